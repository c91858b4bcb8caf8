#pragma once

#include <vector>

#include "nacre/material/relief.h"

namespace nacre::reference {

/// Facets whose normals are off the surface's by tau with density exp(-tau^2 / (2 tilt^2)) per solid angle, as an eye
/// sees them: each by the cosine beta at which it is seen, weighted with that cosine.
struct ModelFacet {
    double cos_beta = 1.0, share = 0.0;  ///< the shares' sum is 1
};
/// @param bends_deg  rising angles at which what they show may have the kink of a root
std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg, const std::vector<double>& bends_deg = {});

/// Facets of a GGX surface of alpha = roughness^2 under even light: visible normals drawn on a square grid (Heitz,
/// "Sampling the GGX Distribution of Visible Normals", JCGT 7 (4), 2018), weighted with Smith's height-correlated G2 /
/// G1 and with whether the light that they mirror comes from above.
/// @param side  so many normals squared; the mean of what is smooth errs by about side^-1.5
std::vector<ModelFacet> rough_facets_seen(double roughness, double theta_deg, int side);

/// The facets of a material's relief, finely enough for colours along an axis.
std::vector<ModelFacet> facets_seen(const Relief& relief, double theta_deg, const std::vector<double>& bends_deg = {});

}  // namespace nacre::reference
