#pragma once

#include <memory>
#include <span>
#include <vector>

#include "nacre/base/spectrum.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/optics/response.h"

namespace nacre {

/// Spectrum of a mechanism at one angle, of the polarisation and of what is observed of it, at the grid's nodes.
Spectrum observed_spectrum(const Mechanism& mechanism, const Geometry& geometry, const WavelengthGrid& grid);

/// What becomes of light at some wavelengths. Palettes, gratings and measurements have no polarisation (s and p are
/// equal), and only layers without a base transmit light (else T = 0). Of uneven layers the mean of
/// `spectrum_thickness_samples` is taken, of spheres that of `spectrum_sizes` radii, of tilted facets the mean over
/// them. Of a grating it is power per unit of u, of scattering the fraction seen (see scatter.h): either may exceed 1.
/// @param wavelengths_nm  vacuum wavelengths, > 0, where the mechanism's materials are known
std::vector<Response> responses_at(const Mechanism& mechanism, const Geometry& geometry,
                                   std::span<const double> wavelengths_nm);
/// The same at one.
Response response_at(const Mechanism& mechanism, const Geometry& geometry, double wavelength_nm);

/// The first material of a mechanism that is not known at a wavelength; null if all are.
std::shared_ptr<const IndexCurve> unknown_at(const Mechanism& mechanism, double wavelength_nm);

inline constexpr int spectrum_thickness_samples = 1024;
inline constexpr int spectrum_sizes = 256;

}  // namespace nacre
