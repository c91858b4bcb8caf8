#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "reference/colour.h"

namespace nacre::reference {

/// A LUT as it is stored, row-major, first row = smallest y.
struct Pixels {
    int width = 0, height = 0;
    std::vector<ModelRgb> rgb;

    const ModelRgb& at(int column, int row) const {
        return rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
    }
};

enum class StoredAs { half_float, single_float };

/// The nearest half, ties to even; any finite double below 65520.
double as_half(double value);

/// The exact colour at LUT coordinates in [0, 1].
using ColourAt = std::function<ModelXyz(double x, double y)>;

/// The LUT that a model itself would store. @param height  1 without a second axis
Pixels make_lut(const ColourAt& model, int width, int height, StoredAs format);

/// What a shader fetches: texel centres at the ends of [0, 1], linear or bilinear filter, clamped.
ModelRgb fetch(const Pixels& lut, double x, double y);

/// The scale at which the brightest texel has Y = 1; of a LUT without light 1.
double scale_of(const Pixels& lut);

/// CIEDE2000 between what a shader fetches and the exact colour there, both at the LUT's scale.
double error_at(const Pixels& lut, double scale, double x, double y, const ModelXyz& exact);

/// How much of a LUT dense_error() looks at.
struct Density {
    int oversample = 10;  ///< points per cell and axis, the cell's own texel among them
    /// Where it takes more: half of them for texels and middles, the rest for the worst cells.
    std::size_t most_points = std::numeric_limits<std::size_t>::max();
    double enough = std::numeric_limits<double>::infinity();  ///< returns as soon as an error exceeds it
};

/// The largest error_at() of a LUT.
double dense_error(const Pixels& stored, const ColourAt& model, const Density& density);

}  // namespace nacre::reference
