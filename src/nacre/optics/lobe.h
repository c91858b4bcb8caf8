#pragma once

namespace nacre {

/// A reflectance band, or a notch: what one palette pick says about one angle.
///
///     R(nm) = floor + (height - floor) B((nm - peak) / width)
///     B(x)  = 1                                      where |x| <= s / 2        s is the flatness
///             cos(pi (|x| - s / 2) / (1 - s))        where s / 2 < |x| < 1 / 2
///             0                                      elsewhere
///
/// Floor and flatness 0 make the half cosine of Park & Tsuruno 2014, J. ADADA 18(1), section 3 (printed there with n /
/// w for pi / w). A floor above the height makes a notch: purples are notches. Floor and height alike are grey.
struct Lobe {
    double peak_nm = 0.0;   ///< wavelength of the maximum, or of a notch's minimum
    double width_nm = 0.0;  ///< from end to end, >= 0 (of a half cosine 2/3 at half height); 0 leaves the floor
    double height = 0.0;    ///< reflectance at the peak, in [0, 1]
    double floor = 0.0;     ///< reflectance far from the peak, in [0, 1]
    double flatness = 0.0;  ///< the plateau's share of the width, in [0, largest_flatness]
    friend bool operator==(const Lobe&, const Lobe&) = default;
};

/// Chosen: sides of a two-thousandth of the width are as steep as a colour can tell.
inline constexpr double largest_flatness = 0.999;

/// Fraction of light reflected at one wavelength, between floor and height.
double lobe_reflectance(const Lobe& lobe, double wavelength_nm);

}  // namespace nacre
