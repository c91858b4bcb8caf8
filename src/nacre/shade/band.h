#pragma once

#include <optional>

#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"

namespace nacre {

/// A band in the reflectance spectrum of any mechanism, described by the three numbers of a lobe.
struct Band {
    double peak_nm = 0.0;               ///< where unpolarised light is reflected most
    double height = 0.0;                ///< reflectance there
    double half_height_width_nm = 0.0;  ///< full width at half of that height
};

/// The band whose peak lies within 15 % of a wavelength.
///
/// None if the spectrum is highest at an end of that range, or does not fall to half of its height on both sides: so
/// black spectra have none, nor has what is seen near grazing, where the surface alone reflects nearly everything.
///
/// A scan in steps of 1/256 of that wavelength, in which one band of a stack of fifty periods is a dozen steps wide,
/// and then ever finer scans around its highest point. The solver is fast at many wavelengths at once; golden-section
/// search needs one at a time, after the same scan. Accuracy: 0.01 nm of the peak, 1 % of the width. Irregular stacks
/// are the mean of `band_thickness_samples`: exact for those.
/// @param expected_nm  vacuum wavelength, > 0; the mechanism's materials are known at 0.6 to 1.6 times that
std::optional<Band> find_band(const Mechanism& mechanism, const Incidence& incidence, double expected_nm);

inline constexpr int band_thickness_samples = 128;

}  // namespace nacre
