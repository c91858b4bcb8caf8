#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/optics/lobe.h"

namespace nacre {

/// A method from a band of reflectance to XYZ that others use; a baseline for nacre's integrals.
///
/// Each is written as well as its method allows: only wavelengths under the band are visited, and white stays white.
/// Sums have their weights computed beforehand and their cosines stepped by SIMD recurrence; fits are evaluated where
/// they are needed, as in shaders: with a table of them one could use the CIE's table.
class Baseline {
public:
    virtual ~Baseline() = default;
    /// XYZ relative to D65, Y = 1 for the perfect reflector.
    virtual Xyz to_xyz(const Lobe& lobe) const = 0;
};

/// A sum over every step-th nanometre of the light's range.
/// @param step_nm  >= 1
std::unique_ptr<Baseline> make_sum_baseline(const Light& light, int step_nm);

/// The same for spectra that are not bands: wavelengths and their weights. White stays white after the adaptation of
/// the light.
SpectralNodes sum_nodes(const Light& light, int step_nm);
/// Of make_three_wavelengths_baseline().
SpectralNodes three_wavelengths_nodes(const Light& light);
/// Of make_fit_baseline().
SpectralNodes fit_nodes(const Light& light, bool single_lobe);

/// The reflectance at the dominant wavelengths of Rec.709's red, green and blue, taken as RGB: rendering in three
/// channels, without observer or illuminant.
std::unique_ptr<Baseline> make_three_wavelengths_baseline();

/// A sum over every fifth nanometre with the matching functions as shaders have them, by the exponentials of Wyman,
/// Sloan, Shirley 2013 (JCGT 2(2), 1-11); the illuminant from its table.
/// @param single_lobe  the article's simpler fit; the only one that there is of the 10 degree observer
std::unique_ptr<Baseline> make_fit_baseline(const Light& light, bool single_lobe);

}  // namespace nacre
