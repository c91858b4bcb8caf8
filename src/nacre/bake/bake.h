#pragma once

#include <functional>

#include "nacre/bake/image.h"
#include "nacre/bake/plan.h"
#include "nacre/bake/work.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// Reflectance spectrum of a mechanism at one angle, at the grid's nodes.
Spectrum reflectance(const Mechanism& mechanism, const Incidence& incidence, const WavelengthGrid& grid);

/// What becomes of the light at one wavelength, per polarisation; each in [0, 1], and R + T <= 1.
struct Response {
    double reflectance_s = 0.0;
    double reflectance_p = 0.0;
    double transmittance_s = 0.0;
    double transmittance_p = 0.0;
};

/// A palette says nothing of polarisation (s and p are alike) and lets nothing through (T = 0).
/// @param wavelength_nm  vacuum wavelength, > 0
Response response_at(const Mechanism& mechanism, const Incidence& incidence, double wavelength_nm);

/// Colour of a mechanism at one angle under a light, before adaptation; the exact integral unless the light samples.
Xyz reflectance_xyz(const Mechanism& mechanism, const Incidence& incidence, const Light& light);

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
