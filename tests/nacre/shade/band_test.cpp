#include "nacre/shade/band.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/paper/paper_stacks.h"

namespace nacre {
namespace {

Layer layer(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

// Pairs of layers, each a quarter wave of `peak_nm` at the normal, in air and on what they are themselves on average.
Stack quarter_waves(double high, double low, int pairs, double peak_nm) {
    Layer group;
    group.repeat = pairs;
    group.layers = {layer(high, peak_nm / (4.0 * high)), layer(low, peak_nm / (4.0 * low))};
    Stack stack;
    stack.incident = 1.0;
    stack.layers = {group};
    stack.substrate = 0.5 * (high + low);
    return stack;
}

Stack films_in_air(int films, double spread_nm) {
    const Layer film = layer(RefractiveIndex{1.56, 0.06}, 94.1);
    Layer group;
    group.repeat = films - 1;
    group.layers = {film, layer(1.0, 83.2)};
    Stack stack;
    stack.incident = 1.0;
    stack.layers = {group, film};
    stack.substrate = 1.0;
    stack.thickness_spread_nm = spread_nm;
    return stack;
}

TEST(Band, OfAPaletteIsItsLobeTwoThirdsAsWideAtHalfHeight) {
    const Palette palette{{{0.0, {500.0, 90.0, 0.8}}}};
    const auto band = find_band(palette, Incidence::from_degrees(20.0), 510.0);
    ASSERT_TRUE(band);
    EXPECT_NEAR(band->peak_nm, 500.0, 0.01);
    EXPECT_NEAR(band->height, 0.8, 1e-6);
    EXPECT_NEAR(band->half_height_width_nm, 60.0, 0.6);  // 1 %, of the scan
}

// (3.2.1). Corrections are of second order in the contrast, 1.2 % here: (0.012)^2 is 1.5e-4. A second surface, or a
// first layer of low index, would add light that is out of step, and let the peak lean by a third of its width.
TEST(Band, WeakLosslessStackPeaksWhereBraggsLawSays) {
    const Stack stack = quarter_waves(1.61, 1.59, 60, 600.0);
    for (const double degrees : {0.0, 20.0, 40.0, 60.0}) {
        const Incidence incidence = Incidence::from_degrees(degrees);
        const double bragg_nm = bragg_peak_nm(stack, incidence);
        const auto band = find_band(stack, incidence, bragg_nm);
        ASSERT_TRUE(band) << degrees;
        EXPECT_NEAR(band->peak_nm / bragg_nm, 1.0, 1.5e-4) << degrees;
    }
}

// The solver's scalar reference implementation, at every two thousandths of a nanometre, as the second road.
TEST(Band, PeakIsFoundToAHundredthOfANanometre) {
    for (const double degrees : {0.0, 35.0}) {
        const Stack stack = films_in_air(10, 0.0);
        const Incidence incidence = Incidence::from_degrees(degrees);
        const LayerSystem system = layer_system(stack);
        const auto band = find_band(stack, incidence, bragg_peak_nm(stack, incidence));
        ASSERT_TRUE(band);
        double best_nm = 0.0;
        double best = 0.0;
        for (int i = -200; i <= 200; ++i) {
            const double nm = band->peak_nm + 0.002 * i;
            const double r = multilayer_response(system, incidence, nm).reflectance();
            if (r > best) {
                best = r;
                best_nm = nm;
            }
        }
        EXPECT_NEAR(band->peak_nm, best_nm, 0.01) << degrees;
        EXPECT_NEAR(band->height, best, 1e-9) << degrees;
    }
}

TEST(Band, BlackAndWhatIsSeenAlongTheSurfaceHaveNone) {
    const Palette black{{{0.0, {500.0, 90.0, 0.0}}}};
    EXPECT_FALSE(find_band(black, Incidence(), 500.0));
    EXPECT_FALSE(find_band(films_in_air(10, 0.0), Incidence::from_degrees(90.0), 225.0));
    EXPECT_FALSE(find_band(films_in_air(10, 0.0), Incidence::from_degrees(85.0), 240.0));
}

TEST(Band, FarFromTheWavelengthThatWasExpectedIsNotFound) {
    const Palette palette{{{0.0, {500.0, 90.0, 0.8}}}};
    EXPECT_TRUE(find_band(palette, Incidence(), 450.0));
    EXPECT_FALSE(find_band(palette, Incidence(), 420.0));
}

// What the figures' README says of the picks' width, which is 47 nm.
TEST(Band, FilmsOfCuticleInAirReflectABroadBandHoweverManyAndHoweverUneven) {
    const Incidence normal;
    const auto width_nm = [&](int films, double spread_nm) {
        return find_band(films_in_air(films, spread_nm), normal, 460.0)->half_height_width_nm;
    };
    EXPECT_NEAR(width_nm(4, 0.0), 171.0, 1.5);
    EXPECT_NEAR(width_nm(10, 0.0), 130.0, 1.5);
    EXPECT_NEAR(width_nm(20, 0.0), 130.0, 1.5);
    for (const double spread_nm : {5.0, 10.0, 16.0, 24.0}) EXPECT_GT(width_nm(10, spread_nm), 125.0) << spread_nm;
}

}  // namespace
}  // namespace nacre
