#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "nacre/optics/incidence.h"
#include "nacre/optics/layer_system.h"
#include "nacre/optics/polarisation.h"
#include "nacre/optics/response.h"

namespace nacre {

struct PreparedLayers;

/// Reflectance and transmittance of plane-parallel layers at one wavelength and angle; exact, all bounces.
///
/// The scalar reference implementation of MultilayerSolver, layer by layer in std::complex, with every repeat computed.
/// Tangential fields are carried from the substrate up: (E, H) with cos a, sin a / q and q sin a, a = 2 pi d q /
/// wavelength, scaled by exp(-|Im a|) (Born & Wolf, Principles of Optics, 7th ed., section 1.6, written with n + ik and
/// exp(-i omega t)). Incoherent layers add intensities (Harbecke 1986, Appl. Phys. B 39, 165-170).
///
/// At 90 degrees exactly the result is the limit from below.
/// @param wavelength_nm  vacuum wavelength, > 0
/// @pre the incident medium is lossless; thicknesses are >= 0; k >= 0
Response multilayer_response(const LayerSystem& system, const Incidence& incidence, double wavelength_nm);

/// The same at many wavelengths at once, prepared for many angles.
///
/// Indices are sampled once. Wavelengths are SIMD lanes (Highway, the best instruction set of the machine); layers
/// without absorption are computed in real numbers at angles at which nothing is evanescent; groups of equal periods
/// are powers of their matrix, by repeated squaring with scaling.
class MultilayerSolver {
public:
    /// @param wavelengths_nm  vacuum wavelengths, > 0, in any order
    MultilayerSolver(const LayerSystem& system, std::span<const double> wavelengths_nm);

    /// Per wavelength. @param out  as many as there are wavelengths
    void responses(const Incidence& incidence, std::span<Response> out) const;

    /// The sums over wavelengths of weight times reflectance, without storing the spectrum. One polarisation takes
    /// about 0.7 of the time of the mean of both, which share sines and cosines.
    /// @param weights  three arrays, of padded_count() numbers each; those beyond count() are 0
    std::array<double, 3> weighted_reflectances(const Incidence& incidence, const std::array<const double*, 3>& weights,
                                                Polarisation polarisation = Polarisation::mean) const;
    /// The same of what is observed; transmittance takes a little longer.
    std::array<double, 3> weighted(const Incidence& incidence, const std::array<const double*, 3>& weights,
                                   Observed observed, Polarisation polarisation) const;

    std::size_t count() const { return count_; }
    std::size_t padded_count() const;

private:
    std::size_t count_ = 0;
    std::shared_ptr<const PreparedLayers> prepared_;
};

}  // namespace nacre
