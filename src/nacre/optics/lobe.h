#pragma once

namespace nacre {

/// A reflectance band shaped like half a cosine: what one palette pick says about one angle.
struct Lobe {
    double peak_nm = 0.0;   ///< wavelength of the maximum
    double width_nm = 0.0;  ///< from zero to zero, >= 0 (the width at half height is 2/3 of it); 0 is black
    double height = 0.0;    ///< reflectance at the peak, in [0, 1]
    friend bool operator==(const Lobe&, const Lobe&) = default;
};

/// Fraction of light reflected at one wavelength, in [0, height].
///
/// height * cos(pi * (wavelength - peak) / width) within half a width of the peak, 0 elsewhere.
/// Source: Park & Tsuruno 2014, J. ADADA 18(1), section 3 (printed there with n / w for pi / w).
double lobe_reflectance(const Lobe& lobe, double wavelength_nm);

}  // namespace nacre
