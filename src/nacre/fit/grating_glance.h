#pragma once

#include <vector>

#include "nacre/bake/light.h"
#include "nacre/optics/grating.h"

namespace nacre {

/// A grating's colour at a glance: the lines of all orders as boxes of their width (wavelength / (orders times
/// grooves)), with the efficiency of their middle. A thousand times faster than GratingColour, and good enough to tell
/// where a search should begin: few grooves, whose lines have much of their light in their flanks, err most.
class GratingGlance {
public:
    explicit GratingGlance(const Light& light);

    /// Before adaptation. @param u  in (0, 2]
    Xyz at(const Grating& grating, double u) const;

private:
    // Of all light below a wavelength.
    Xyz below(double wavelength_nm) const;

    double first_nm_;
    std::vector<Xyz> sums_;  // up to every whole nanometre
};

}  // namespace nacre
