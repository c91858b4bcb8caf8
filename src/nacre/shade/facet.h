#pragma once

namespace nacre {

/// Facets that show one colour, because the eye sees them at one angle.
struct Facet {
    double cos_theta = 1.0;  ///< at which they are seen
    double share = 0.0;      ///< of what is seen in all
};

}  // namespace nacre
