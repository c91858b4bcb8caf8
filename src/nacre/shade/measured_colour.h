#pragma once

#include <memory>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/shade/work.h"

namespace nacre {

/// The colour of measured spectra: exact, because spectra and weights are both linear between their nodes.
class MeasuredColour {
public:
    MeasuredColour(const MeasuredSpectra& spectra, const Light& light);

    /// Before adaptation. @param work  what it takes is added
    Xyz at(const Incidence& incidence, Work* work = nullptr) const;
    std::uint64_t samples() const { return weights_.size(); }

private:
    MeasuredCurve curve_;
    std::vector<Xyz> weights_;  // per wavelength of the spectra
};

}  // namespace nacre
