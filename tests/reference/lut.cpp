#include "reference/lut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nacre::reference {

double as_half(double value) {
    if (value == 0.0) return 0.0;
    // 11 significant bits; below 2^-14 steps of 2^-24. nearbyint rounds ties to even.
    const int exponent = std::max(std::ilogb(value) - 10, -24);
    return std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
}

Pixels make_lut(const ColourAt& model, int width, int height, StoredAs format) {
    Pixels lut{width, height, {}};
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double y = height > 1 ? static_cast<double>(row) / (height - 1) : 0.0;
            ModelRgb rgb = to_rec709(model(static_cast<double>(column) / (width - 1), y));
            for (double& component : rgb) {
                component = format == StoredAs::half_float ? as_half(component)
                                                           : static_cast<double>(static_cast<float>(component));
            }
            lut.rgb.push_back(rgb);
        }
    }
    return lut;
}

namespace {

struct Tap {
    int low = 0, high = 0;
    double share = 0.0;  // of the high one
};

Tap tap_at(double coordinate, int size) {
    const double texcoord = (coordinate * (size - 1) + 0.5) / size;
    const double position = texcoord * size - 0.5;
    const double low = std::floor(position);
    const auto clamped = [&](double texel) { return static_cast<int>(std::clamp(texel, 0.0, size - 1.0)); };
    return {clamped(low), clamped(low + 1.0), position - low};
}

}  // namespace

ModelRgb fetch(const Pixels& lut, double x, double y) {
    const Tap across = tap_at(x, lut.width), down = tap_at(y, lut.height);
    ModelRgb rgb{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto row = [&](int r) {
            return (1.0 - across.share) * lut.at(across.low, r)[c] + across.share * lut.at(across.high, r)[c];
        };
        rgb[c] = (1.0 - down.share) * row(down.low) + down.share * row(down.high);
    }
    return rgb;
}

double scale_of(const Pixels& lut) {
    double brightest = 0.0;
    for (const ModelRgb& rgb : lut.rgb) brightest = std::max(brightest, from_rec709(rgb).y);
    return scale_of_brightest(brightest);
}

double error_at(const Pixels& lut, double scale, double x, double y, const ModelXyz& exact) {
    return difference(from_rec709(fetch(lut, x, y)), exact, scale);
}

namespace {

// Coordinates along one axis of one cell: its first texel and `oversample` - 1 points inside; in the last cell the
// last texel too.
int points_of_cell(int cell, int texels, int oversample) {
    if (texels == 1) return 1;
    return cell == texels - 2 ? oversample + 1 : oversample;
}

double cell_error(const Pixels& lut, const ColourAt& model, int column, int row, int oversample, double scale) {
    double worst = 0.0;
    const int across = points_of_cell(column, lut.width, oversample);
    const int down = points_of_cell(row, lut.height, oversample);
    for (int j = 0; j < down; ++j) {
        const double y = lut.height > 1 ? (row + static_cast<double>(j) / oversample) / (lut.height - 1) : 0.0;
        for (int i = 0; i < across; ++i) {
            const double x = lut.width > 1 ? (column + static_cast<double>(i) / oversample) / (lut.width - 1) : 0.0;
            worst = std::max(worst, error_at(lut, scale, x, y, model(x, y)));
        }
    }
    return worst;
}

// The step-th index below count: steps of the golden section, so that any number of them is spread evenly, and `count`
// of them are all.
std::size_t spread_index(std::size_t step, std::size_t count) {
    auto stride = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(count)) + 1;
    while (std::gcd(stride, count) != 1) ++stride;
    return step * stride % count;
}

}  // namespace

double dense_error(const Pixels& stored, const ColourAt& model, const Density& density) {
    const double scale = scale_of(stored);
    const auto columns = static_cast<std::size_t>(std::max(stored.width - 1, 1));
    const auto all = columns * static_cast<std::size_t>(std::max(stored.height - 1, 1));
    const auto points_of = [&](int oversample) {
        const auto per_axis = static_cast<std::size_t>(oversample);
        return stored.height > 1 ? per_axis * per_axis : per_axis;
    };
    const auto error_of = [&](std::size_t cell, int oversample) {
        const int column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
        return cell_error(stored, model, column, row, oversample, scale);
    };
    const bool all_fit = all <= density.most_points / points_of(density.oversample);
    // Too many points: texels and middles first, and then the worst cells as closely as was asked.
    const int first_pass = all_fit ? density.oversample : 2;
    const std::size_t visited =
        all_fit ? all : std::clamp<std::size_t>(density.most_points / 2 / points_of(first_pass), 1, all);
    std::vector<std::pair<double, std::size_t>> cells_by_error;
    double worst = 0.0;
    for (std::size_t step = 0; step < visited && worst <= density.enough; ++step) {
        const std::size_t cell = spread_index(step, all);
        cells_by_error.emplace_back(error_of(cell, first_pass), cell);
        worst = std::max(worst, cells_by_error.back().first);
    }
    if (all_fit) return worst;
    std::sort(cells_by_error.rbegin(), cells_by_error.rend());
    const std::size_t closely = density.most_points / 2 / points_of(density.oversample);
    for (std::size_t i = 0; i < std::min(closely, visited) && worst <= density.enough; ++i)
        worst = std::max(worst, error_of(cells_by_error[i].second, density.oversample));
    return worst;
}

}  // namespace nacre::reference
