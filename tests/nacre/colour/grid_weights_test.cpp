#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/optics/lobe.h"
#include "reference/weights.h"

namespace nacre {
namespace {

using reference::Number;

const WavelengthGrid grids[] = {{360.0, 830.0, 471}, {360.0, 830.0, 95}, {360.0, 830.0, 48},  {380.0, 780.0, 81},
                                {400.0, 700.0, 3},   {360.0, 830.0, 2},  {430.0, 650.0, 3},   {361.3, 829.1, 137},
                                {360.0, 830.0, 997}, {555.2, 555.9, 12}, {360.0, 830.0, 4701}};

TristimulusWeights d65_weights() {
    return make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("D65"));
}

TEST(GridWeights, SpectrumOfOnesHasYOneAndIsTheGridsWhite) {
    for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg}) {
        for (const std::string_view name : illuminant_names()) {
            const TristimulusWeights weights = make_tristimulus_weights(observer, *illuminant_by_name(name));
            for (const WavelengthGrid& grid : grids) {
                if (grid.count == 2 && name.substr(0, 2) == "FL") continue;  // a lamp has no power at 360 and 830 nm
                const GridWeights grid_weights = make_grid_weights(weights, grid);
                const Spectrum ones{grid, std::vector<double>(static_cast<std::size_t>(grid.count), 1.0)};
                const Xyz white = to_xyz(grid_weights, ones);
                // A sum of thousands of numbers of one sign; 1e-12 is what white is promised to.
                EXPECT_NEAR(white.y, 1.0, 1e-12) << name << ' ' << grid.count;
                EXPECT_NEAR(white.x, grid_weights.white.x, 1e-12 * white.x) << name << ' ' << grid.count;
                EXPECT_NEAR(white.z, grid_weights.white.z, 1e-12 * white.x) << name << ' ' << grid.count;
                EXPECT_NEAR(grid_weights.white.y, 1.0, 1e-12) << name << ' ' << grid.count;
            }
        }
    }
}

/// The piecewise linear function through weights that are one nanometre apart.
Number weight_at(const std::vector<Number>& values, int first_nm, const Number& wavelength_nm) {
    const Number place = wavelength_nm - first_nm;
    const std::size_t node = std::min(static_cast<std::size_t>(static_cast<double>(floor(place))), values.size() - 2);
    const Number t = place - Number(node);
    return (1 - t) * values[node] + t * values[node + 1];
}

TEST(GridWeights, AreTheTrapeziumRuleAtTheNodesOfTheGrid) {
    const TristimulusWeights weights = d65_weights();
    const reference::Weights exact = reference::weights_from_files("cmf_cie1931_2deg_1nm.csv", "D65", 360, 830);
    for (const WavelengthGrid& grid : grids) {
        std::vector<Number> x, y, z;
        Number luminance = 0;
        for (int i = 0; i < grid.count; ++i) {
            const Number wavelength =
                Number(grid.first_nm) + (Number(grid.last_nm) - Number(grid.first_nm)) * i / (grid.count - 1);
            const Number share = i == 0 || i + 1 == grid.count ? Number(0.5) : Number(1);
            x.push_back(share * weight_at(exact.x, 360, wavelength));
            y.push_back(share * weight_at(exact.y, 360, wavelength));
            z.push_back(share * weight_at(exact.z, 360, wavelength));
            luminance += y.back();
        }
        const GridWeights grid_weights = make_grid_weights(weights, grid);
        ASSERT_EQ(grid_weights.x.size(), x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            // A node rounds to 1.1e-13 nm and a weight changes by up to a sixth of itself per nanometre: 2e-14 of it,
            // and some more for the sum.
            EXPECT_LT(reference::relative_distance(grid_weights.x[i], x[i] / luminance), 5e-14) << grid.count;
            EXPECT_LT(reference::relative_distance(grid_weights.y[i], y[i] / luminance), 5e-14) << grid.count;
            EXPECT_NEAR(grid_weights.z[i], static_cast<double>(z[i] / luminance), 5e-14) << grid.count;  // z ends in 0
        }
    }
}

Xyz sampled_lobe(const TristimulusWeights& weights, const Lobe& lobe, const WavelengthGrid& grid) {
    Spectrum spectrum{grid, {}};
    for (int i = 0; i < grid.count; ++i) spectrum.value.push_back(lobe_reflectance(lobe, grid.wavelength_nm(i)));
    return to_xyz(make_grid_weights(weights, grid), spectrum);
}

TEST(GridWeights, SampledLobeConvergesToTheExactOneAsTheSquareOfTheStep) {
    const TristimulusWeights weights = d65_weights();
    const Lobe lobe{511.3, 67.9, 0.8};
    const Xyz unit = band_to_xyz(weights, {lobe.peak_nm, lobe.width_nm});
    const Xyz exact{lobe.height * unit.x, lobe.height * unit.y, lobe.height * unit.z};
    double error_before = 1.0;
    for (const int per_nm : {4, 16, 64, 256}) {
        const Xyz sampled = sampled_lobe(weights, lobe, {360.0, 830.0, 470 * per_nm + 1});
        const double error =
            std::max({std::abs(sampled.x - exact.x), std::abs(sampled.y - exact.y), std::abs(sampled.z - exact.z)});
        // The kinks of lobe and weights cost h^2 w'' / 12; 0.01 bounds the sum of their slopes for this lobe.
        EXPECT_LT(error, 0.01 / (per_nm * per_nm));
        // Where the kink at the lobe's end falls in its cell is chance, so fourfold finer is not 16 times better
        // each time, but always clearly better.
        EXPECT_LT(error, error_before / 4.0);
        error_before = error;
    }
}

}  // namespace
}  // namespace nacre
