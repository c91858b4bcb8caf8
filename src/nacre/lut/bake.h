#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/response.h"
#include "nacre/scene/plan.h"
#include "nacre/shade/work.h"

namespace nacre {

/// Reflectance spectrum of a mechanism at one angle, of the polarisation that it asks for, at the grid's nodes.
Spectrum reflectance(const Mechanism& mechanism, const Geometry& geometry, const WavelengthGrid& grid);

/// What becomes of light at some wavelengths. Palettes, gratings and measurements say nothing of polarisation (s and p
/// are alike), and only layers without a base let anything through (else T = 0). Of uneven layers the mean of
/// `spectrum_realisations` is taken, of spheres that of `spectrum_sizes` radii, of tilted facets the mean over them. Of
/// a grating it is power per unit of u, of scattering the fraction seen (see scatter.h): either may exceed 1.
/// @param wavelengths_nm  vacuum wavelengths, > 0, where the mechanism's materials are known
std::vector<Response> responses_at(const Mechanism& mechanism, const Geometry& geometry,
                                   std::span<const double> wavelengths_nm);
/// The same at one.
Response response_at(const Mechanism& mechanism, const Geometry& geometry, double wavelength_nm);

/// The first material of a mechanism that is not known at a wavelength; null if all are.
std::shared_ptr<const IndexCurve> unknown_at(const Mechanism& mechanism, double wavelength_nm);

inline constexpr int spectrum_realisations = 1024;
inline constexpr int spectrum_sizes = 256;

/// Colour of a mechanism at one angle under a light, before adaptation; the exact integral of a palette, and nodes that
/// are good for CIEDE2000 0.001 of anything else, unless the light samples.
Xyz reflectance_xyz(const Mechanism& mechanism, const Geometry& geometry, const Light& light);

/// Called after every row of a bake; what it throws ends the bake.
using AfterRow = std::function<void()>;

/// Every texel of a LUT: XYZ relative to D65 (after adaptation), Y = 1 for the perfect reflector.
///
/// Texel (i, j) is the value at coordinates (i / (width - 1), j / (height - 1)); the first row is the smallest y.
/// @param work  what it took is added to it
Image<Xyz> bake(const Job& job, const AfterRow& after_row = {}, Work* work = nullptr);

/// The value that texel-centre sampling at (x, y) stands for: what bake() samples, in closed form unless the light
/// samples. Coordinates in [0, 1].
Xyz exact_xyz(const Job& job, double x, double y = 0.0);

}  // namespace nacre
