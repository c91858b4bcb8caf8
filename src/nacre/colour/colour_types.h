#pragma once

namespace nacre {

/// CIE tristimulus values; Y = 1 for the perfect reflector. Negative values never come from a reflectance.
struct Xyz {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    friend bool operator==(const Xyz&, const Xyz&) = default;
};

/// Three components of some RGB space. The code that makes the numbers says which; scene-linear unless the name says
/// `display_referred`. Components may be negative or exceed 1.
struct Rgb {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// CIE (x, y). The white that scene-linear RGB of this project is made for is `d65_chromaticity`.
struct Chromaticity {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

/// D65 as every RGB standard rounds it (IEC 61966-2-1, ITU-R BT.709): four decimals, not the table's own white.
inline constexpr Chromaticity d65_chromaticity{0.3127, 0.3290};

/// @pre chromaticity.y > 0
inline constexpr Xyz xyz_from_chromaticity(Chromaticity chromaticity, double luminance = 1.0) {
    return {luminance * chromaticity.x / chromaticity.y, luminance,
            luminance * (1.0 - chromaticity.x - chromaticity.y) / chromaticity.y};
}

/// The white that all colours of this project are relative to, at Y = 1.
inline constexpr Xyz d65_white = xyz_from_chromaticity(d65_chromaticity);

/// @pre x + y + z > 0
inline constexpr Chromaticity chromaticity_of(Xyz colour) {
    const double sum = colour.x + colour.y + colour.z;
    return {colour.x / sum, colour.y / sum};
}

}  // namespace nacre
