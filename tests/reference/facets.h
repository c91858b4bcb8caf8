#pragma once

#include <vector>

namespace nacre::reference {

/// Facets whose normals are off the surface's by tau with density exp(-tau^2 / (2 tilt^2)) per solid angle, as an eye
/// sees them: each by the cosine beta at which it is seen, weighted with that cosine.
struct ModelFacet {
    double cos_beta = 1.0, share = 0.0;  ///< the shares' sum is 1
};
/// @param bends_deg  rising angles at which what they show may have the kink of a root
std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg, const std::vector<double>& bends_deg = {});

}  // namespace nacre::reference
