#pragma once

namespace nacre {

/// How the facets lean that a surface consists of: by one of two laws, or not at all. At most one number is not 0.
struct Relief {
    double tilt_deg = 0.0;   ///< small mirrors side by side: scales, grains, brush marks. See tilted_facets()
    double roughness = 0.0;  ///< in [0, 1], GGX: what a renderer calls rough. See rough_facets()

    bool is_plane() const { return tilt_deg == 0.0 && roughness == 0.0; }
    friend bool operator==(const Relief&, const Relief&) = default;
};

}  // namespace nacre
