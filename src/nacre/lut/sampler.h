#pragma once

#include <optional>

#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/prepared_colour.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// A job prepared for evaluation at many points. It does not compute again what has not changed since the last point,
/// so evaluate points row by row.
class Sampler {
public:
    /// @param job  has to outlive the sampler
    explicit Sampler(const Job& job);

    /// XYZ relative to D65 (after adaptation), Y = 1 for the perfect reflector.
    /// @param x,y  coordinates on the job's axes, in [0, 1]; y is ignored without an axis y
    Xyz at(double x, double y = 0.0);

    /// The band of reflectance behind that colour. @pre the job's material is a palette
    Lobe lobe_at(double x, double y = 0.0);

    /// The work of all evaluations so far.
    const Work& work() const { return work_; }

private:
    void set_parameters(double x, double y);
    const Geometry& geometry(double x, double y);
    Xyz mean_of_facets(const Incidence& incidence);

    const Job& job_;
    Mechanism mechanism_;
    SpectralSampling sampling_;
    PreparedColour prepared_;       // the colour of the mechanism at many angles
    FacetColours facets_;           // its colours, if facets ask for them
    std::optional<double> last_x_;  // of parameters, where they are axes
    std::optional<double> last_y_;
    std::optional<double> last_angle_;  // coordinate on the axis that is the angle
    Geometry geometry_;                 // there
    Work work_;
};

}  // namespace nacre
