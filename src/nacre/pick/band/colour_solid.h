#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/pick/band/unit_bands.h"

namespace nacre {

/// The colours of all reflectances in [0, 1] under one light: the solid of Rösch and MacAdam.
///
/// How far it reaches along a colour is a linear program over all reflectances. By duality the largest t with
/// t * colour = integral of R(nm) w(nm), 0 <= R <= 1, is the least of F(n) = integral of max(0, n . w(nm)) over all n
/// with n . colour = 1. F is convex, its slope is the colour of the reflectance that is 1 where n . w > 0, and Newton's
/// method in the plane n . colour = 1 finds its least value. It starts at the best of some planes that touch the solid.
class ColourSolid {
public:
    /// Takes some 0.2 milliseconds. @param weights  has to outlive this
    explicit ColourSolid(const TristimulusWeights& weights);

    /// Chosen: what would become as good as black counts as outside the spectral locus.
    static constexpr double least_share = 1e-4;

    /// A reflectance that is 1 on one stretch of wavelengths and 0 elsewhere; of a notch the other way round.
    struct Stretch {
        BandKind kind = BandKind::band;
        double from_nm = 0.0;
        double to_nm = 0.0;
    };

    /// Where a ray from black leaves the solid.
    struct Boundary {
        double share = 0.0;  ///< of the colour, in [0, inf); 0 outside the spectral locus and below least_share
        Stretch stretch;     ///< the reflectance there, but for dents (see nearest())
    };

    /// @pre colour.x + 15 colour.y + 3 colour.z > 0
    Boundary along(const Xyz& colour) const;

    /// The stretch that has a colour's luminance, at most 1, and is nearest to it.
    ///
    /// Were the spectral locus convex, the stretches would be the boundary of the solid (Schrödinger). The 1 nm tables
    /// of the CIE have dents of up to 7e-6 in (x, y), so that colours as near to the locus as that may lie outside all
    /// stretches of their luminance, by about the dent's depth.
    Stretch nearest(const Xyz& colour) const;

    Xyz colour_of(const Stretch& stretch) const;

private:
    struct Support;
    struct Step {
        glm::dvec3 step;
        double doubt;
    };
    template <typename Visit>
    bool visit_jumps(const glm::dvec3& n, const Visit& visit) const;
    Support support(const glm::dvec3& n) const;
    glm::dvec3 best_touching(const glm::dvec3& colour) const;
    Step newton_step(const glm::dvec3& target, const glm::dvec3& n, const Support& here) const;
    Stretch best_stretch(const glm::dvec3& n) const;
    double nm_of_luminance(double luminance) const;
    Stretch stretch_at(double nm, bool is_end, double luminance) const;
    glm::dvec3 node(std::size_t i) const;
    glm::dvec3 integral_to(double nm) const;

    const TristimulusWeights& weights_;
    std::vector<glm::dvec3> touching_;  // n of planes n . colour = 1 that touch the solid
};

}  // namespace nacre
