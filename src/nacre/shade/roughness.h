#pragma once

#include <array>
#include <span>
#include <vector>

#include "nacre/base/gauss_points.h"
#include "nacre/optics/incidence.h"
#include "nacre/shade/facet.h"

namespace nacre {

/// The facets of a rough surface that light reaches evenly from all sides, as an eye sees them.
///
/// GGX: the density of normals h per solid angle goes with 1 / (1 - (1 - alpha^2) cos^2(h, n))^2, alpha = roughness^2.
/// What is seen of a facet goes with cos(h, v), and with the part of it that is neither hidden from the eye v nor in
/// shade for the light l that it mirrors to the eye: Smith's height-correlated (1 + L(v)) / (1 + L(v) + L(l)), L(v) =
/// (sqrt(1 + alpha^2 tan^2(v, n)) - 1) / 2, where l is above the surface. The shares sum to 1, so that a perfect
/// reflector is white at every roughness and angle; what light loses between facets is for the renderer's own energy
/// term. Light that is reflected by more than one facet is left out.
///
/// Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007 (the distribution); Heitz,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3 (2), 2014 (visible normals, 99).
///
/// What the colour of a facet depends on is the angle to the eye, so the integral is taken around the line of sight:
/// over that angle by Gauss-Legendre rules between borders that lie close where the integrand is steep, and around it
/// in the variable that makes the density a polynomial. Means of smooth colours err by 1e-5.
class RoughFacets {
public:
    RoughFacets();
    /// @param roughness   in (0, 1]
    /// @param angles_rad  in [0, pi/2]: between two of them a colour is to be a polynomial of low degree; rules do not
    ///                    reach across them
    std::vector<Facet> at(double roughness, const Incidence& incidence, std::span<const double> angles_rad = {}) const;

    /// Of half a turn u around the line of sight: w = sin(u / 2), and what belongs to its place beside dw.
    struct PointAround {
        double whole_w = 0.0;
        double whole_weight = 0.0;
        double part_w = 0.0;  ///< where light begins to come from below: as part of the last w, and crowded there
        double part_weight = 0.0;
    };

private:
    std::vector<GaussPoint> between_borders_;
    std::array<PointAround, 10> around_;
};

}  // namespace nacre
