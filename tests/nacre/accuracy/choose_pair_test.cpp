#include "nacre/accuracy/choose_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "nacre/accuracy/measure.h"
#include "nacre/lut/fetch.h"
#include "nacre/scene/readers/axis_reader.h"
#include "reference/materials.h"
#include "reference/random_scenes.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

const Encoding encoding = test::rec709_encoding();

Layer layer_of(const Index& index, double thickness_nm, bool is_incoherent = false) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    layer.is_incoherent = is_incoherent;
    return layer;
}

struct Named {
    std::string name;
    Mechanism mechanism;
    Relief relief{};
};

// Nothing in them absorbs.
std::vector<Named> lossless_materials() {
    const Film bubble{1.0, 1.33, 420.0, 1.0, 0.0};
    const Film on_metal{1.0, 2.1, 180.0, RefractiveIndex(0.2, 3.4), 0.0};
    const Film behind_prism{1.8, 1.38, 600.0, 1.5, 0.0};
    const Film uneven{1.0, 1.6, 500.0, 1.5, 30.0};
    const Film thick{1.0, 1.6, 60000.0, 1.45, 0.0};
    const Stack pane{1.0, {layer_of(1.38, 100.0), layer_of(1.52, 1e6, true), layer_of(1.38, 100.0)}, 1.0, 0.0};
    Layer period;
    period.repeat = 7;
    period.layers = {layer_of(2.3, 60.0), layer_of(1.46, 95.0)};
    const Stack mirror{1.0, {period}, 1.52, 0.0};
    Crystal opal;
    opal.sphere = 1.45;
    opal.medium = 1.0;
    opal.planes = 8;
    opal.substrate = 1.45;
    return {{"bubble", bubble},
            {"film on a metal", on_metal},
            {"film behind a prism", behind_prism},
            {"uneven", uneven},
            {"thick", thick},
            {"pane", pane},
            {"mirror", mirror},
            {"opal", opal},
            {"tilted", mirror, {10.0, 0.0}},
            {"hardly tilted", bubble, {0.2, 0.0}},
            {"rough", mirror, {0.0, 0.4}},
            {"matte", bubble, {0.0, 1.0}}};
}

std::array<PlannedLut, 2> pair_of(const Named& material, double max_de00) {
    Job job = test::job_of(test::morpho);
    job.material = {material.name, material.mechanism, {}};
    job.material.mechanism.effects.relief = material.relief;
    std::array<PlannedLut, 2> pair;
    pair.fill(test::requested_lut(job, max_de00));
    pair[1].job.material.mechanism.effects.observed = Observed::transmittance;
    return pair;
}

Image<Rgb> stored(const ChosenLut& chosen) {
    return test::stored_lut(chosen.lut.job, chosen.lut.format);
}

// Half of the last digit of a number in half; of one in float, and of the matrices, next to nothing.
double rounding_of(double value, PixelFormat format) {
    constexpr double of_sums = 1e-9;
    if (format == PixelFormat::single_float) return std::ldexp(std::abs(value), -24) + of_sums;
    return std::ldexp(1.0, std::max(std::ilogb(value), -14) - 11) + of_sums;
}

// Of one size, format and sampling; at most as far from white as the texels' own rounding, at random coordinates.
void expect_white(const ChosenPair& pair, double more_than_rounding) {
    const std::string& name = pair[0].lut.job.material.name;
    ASSERT_EQ(size_text(pair[0].lut.job), size_text(pair[1].lut.job)) << name;
    ASSERT_EQ(pair[0].lut.format, pair[1].lut.format) << name;
    EXPECT_EQ(pair[0].lut.job.sampling.counts(), pair[1].lut.job.sampling.counts()) << name;
    EXPECT_EQ(pair[0].lut.job.sampling.incoherent_layers, pair[1].lut.job.sampling.incoherent_layers) << name;
    EXPECT_EQ(pair[0].lut.job.without, pair[1].lut.job.without) << name;
    const Image<Rgb> r = stored(pair[0]), t = stored(pair[1]);
    double most = 0.0;  // of the texels' roundings
    for (std::size_t i = 0; i < r.size(); ++i) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            const double rounding = rounding_of(r.data()[i].*component, pair[0].lut.format) +
                                    rounding_of(t.data()[i].*component, pair[1].lut.format);
            EXPECT_LE(std::abs(r.data()[i].*component + t.data()[i].*component - 1.0), rounding + more_than_rounding)
                << name << ", texel " << i;
            most = std::max(most, rounding);
        }
    }
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const LutPoint at{anywhere(generator), anywhere(generator)};
        const Rgb reflected = fetch(r, at), transmitted = fetch(t, at);
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b})
            EXPECT_NEAR(reflected.*component + transmitted.*component, 1.0, most + more_than_rounding)
                << name << " at " << at.x;
    }
}

TEST(ChoosePair, IsWhiteWhereNothingAbsorbs) {
    for (const Named& material : lossless_materials()) {
        for (const double bound : {1.0, 0.1}) {
            const ChosenPair pair = choose_pair(pair_of(material, bound), encoding);
            // A mean over facets is taken from a curve of its own, which errs by far less than half rounds.
            expect_white(pair, material.relief.is_plane() ? 0.0 : 2e-5);
            for (const ChosenLut& chosen : pair) {
                if (!chosen.is_reached) continue;
                EXPECT_LE(measure(chosen, bake(chosen.lut.job), stored(chosen), encoding).reached, bound)
                    << material.name;
            }
        }
    }
}

// Films and stacks as they come, dispersive and on metals, but for their k.
TEST(ChoosePair, OfRandomLosslessLayersIsWhite) {
    EffectSet absorption;
    absorption.insert(Effect::absorption);
    const std::vector<reference::ModelScene> scenes = reference::random_layers();
    for (std::size_t i = 0; i < scenes.size(); i += 7) {
        Mechanism mechanism = scenes[i].mechanism;
        for_each_index(mechanism, [](Index& index, IndexRole) {
            if (index.curve) index = reference::tabulated_index(index.curve->name);
        });
        remove(absorption, mechanism, 360.0);
        expect_white(choose_pair(pair_of({scenes[i].name, mechanism}, 1.0), encoding), 0.0);
    }
}

TEST(ChoosePair, OfTwoAxesIsWhiteToo) {
    std::array<PlannedLut, 2> pair = pair_of(lossless_materials().front(), 1.0);
    for (PlannedLut& lut : pair) {
        lut.job.y = parameter_axis(lut.job.material.mechanism, "thickness_nm", 100.0, 400.0);
        lut.request.width = 64;
        lut.request.height = 64;
        lut.job.height = 64;
    }
    expect_white(choose_pair(pair, encoding), 0.0);
}

TEST(ChoosePair, HasWhatEitherNeedsAlone) {
    for (const Named& material : lossless_materials()) {
        const std::array<PlannedLut, 2> luts = pair_of(material, 0.1);
        const ChosenPair pair = choose_pair(luts, encoding);
        for (std::size_t i = 0; i < 2; ++i) {
            const ChosenLut alone = choose_lut(luts[i], encoding);
            EXPECT_GE(pair[i].lut.job.width, alone.lut.job.width) << material.name;
            EXPECT_GE(pair[i].lut.job.sampling.counts().nodes, alone.lut.job.sampling.counts().nodes);
            EXPECT_TRUE(pair[i].lut.job.without.minus(alone.lut.job.without).is_empty()) << material.name;
            EXPECT_EQ(pair[i].is_reached, alone.is_reached) << material.name;
            EXPECT_FALSE(pair[i].lut.request.width) << "what was asked for stays so";
            EXPECT_EQ(pair[i].lut.job.material.mechanism.effects.observed,
                      i == 0 ? Observed::reflectance : Observed::transmittance);
        }
    }
}

}  // namespace
}  // namespace nacre
