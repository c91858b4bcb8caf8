// Every colour that a reflectance can have has a band, and every other one is dimmed no more than it must be. A linear
// program over all reflectances says which is which; an integral of the reference model says what a band looks like.
// NACRE_PICK_SWEEP=1 takes 10000 colours under every light.
#include "nacre/pick/band/exact_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <tuple>

#include "nacre/pick/band/picked_bands.h"
#include "reference/optimal_colour.h"

namespace nacre::test {
namespace {

using reference::ModelRgb;
using reference::ModelXyz;

// Invisible: CIEDE2000 1 is about a just noticeable difference.
constexpr double exact_de00 = 0.01;

double hue_difference_deg(const Xyz& one, const Xyz& two) {
    const auto a = reference::oklab_of(as_model(one)), b = reference::oklab_of(as_model(two));
    const double sine = a[1] * b[2] - a[2] * b[1], cosine = a[1] * b[1] + a[2] * b[2];
    return std::abs(std::atan2(sine, cosine)) * 180.0 / std::numbers::pi;
}

struct Space {
    const char* name;
    ModelXyz (*to_xyz)(const ModelRgb& rgb);
};
void PrintTo(const Space& space, std::ostream* out) {
    *out << space.name;
}

// Even as a screen shows them, so that dark and saturated colours are among them.
ModelXyz p3_colour(const ModelRgb& encoded) {
    return reference::from_p3d65({std::pow(encoded[0], 2.4), std::pow(encoded[1], 2.4), std::pow(encoded[2], 2.4)});
}
ModelXyz acescg_colour(const ModelRgb& encoded) {
    return reference::from_acescg({std::pow(encoded[0], 2.4), std::pow(encoded[1], 2.4), std::pow(encoded[2], 2.4)});
}

class Judge {
public:
    explicit Judge(const std::string& illuminant) : light_(illuminant), optimal_(light_.model) {}

    void look_at(const ModelXyz& picked, const std::string& name) {
        const Xyz colour = as_xyz(picked);
        const ShownColour shown = shown_colour(light_.bands, light_.core, colour);
        const Lobe band = light_.only_band(shown.colour);
        const std::string what = name + " as " + text_of(band);
        if (!is_a_reflectance(band)) failures.add(what + " is none that a surface can have");
        const double miss = light_.difference(band, shown.colour);
        if (!(miss <= exact_de00)) failures.add(what + " misses by " + std::to_string(miss));
        const double most = optimal_.brightest_share(light_.model.seen_as(picked));
        if (most >= 1.0) {
            ++reachable;
            const double de00 = light_.difference(band, colour);
            if (!(de00 <= exact_de00)) failures.add(what + " can be had, and differs by " + std::to_string(de00));
        } else if (most > 1e-3) {
            ++dimmed;
            see_dimmed(picked, shown.colour, most, what);
        } else {
            ++outside;
            see_outside(shown.colour, what);
        }
        if (picked.y > 1e-4 && hue_difference_deg(colour, shown.colour) > 1.0 && shown.colour.y > 1e-6)
            failures.add(what + " changes its hue by " + std::to_string(hue_difference_deg(colour, shown.colour)));
    }

    Failures failures;
    int reachable = 0, dimmed = 0, outside = 0;

private:
    void see_dimmed(const ModelXyz& picked, const Xyz& shown, double most, const std::string& what) {
        const double share = shown.y / picked.y;
        const bool is_scaled = std::abs(shown.x - share * picked.x) + std::abs(shown.z - share * picked.z) < 1e-9;
        if (!is_scaled) failures.add(what + " changes its chromaticity; could have " + std::to_string(most));
        if (!(share >= 0.99 * most && share <= most * (1.0 + 1e-4)))
            failures.add(what + " has " + std::to_string(share) + " of its luminance, could have " +
                         std::to_string(most));
    }
    // Beyond the locus: what is shown is as bright as its own chromaticity can be, or as was picked.
    void see_outside(const Xyz& shown, const std::string& what) {
        if (shown.y < 1e-6) return;
        const double most = optimal_.brightest_share(light_.model.seen_as(as_model(shown)));
        if (!(most >= 1.0 - 1e-5)) failures.add(what + " shows what no reflectance has: " + std::to_string(most));
    }

    PickLight light_;
    reference::OptimalColours optimal_;
};

class ExactBands10000 : public testing::TestWithParam<std::tuple<std::string, Space>> {};

TEST_P(ExactBands10000, HaveEveryColourThatAReflectanceHasAndDimTheOthersAsLittleAsCanBe) {
    const auto& [illuminant, space] = GetParam();
    Judge judge(illuminant);
    reference::Dice dice(2014);
    const int count = sweeps_all_picks() ? 10000 : 600;
    for (int i = 0; i < count; ++i) {
        const ModelRgb rgb = random_rgb(dice);
        char name[80];
        std::snprintf(name, sizeof name, "[%.17g, %.17g, %.17g]", rgb[0], rgb[1], rgb[2]);
        judge.look_at(space.to_xyz(rgb), name);
    }
    EXPECT_EQ(judge.failures.count, 0) << "of " << count << ", such as" << judge.failures.first.str();
    if (std::string(space.name) == "sRGB" && illuminant == "D65") {
        EXPECT_EQ(judge.reachable, count);
    }
    RecordProperty("reachable", judge.reachable);
    RecordProperty("dimmed", judge.dimmed);
    RecordProperty("outside", judge.outside);
}

INSTANTIATE_TEST_SUITE_P(All, ExactBands10000,
                         testing::Combine(testing::Values("D65", "A", "E"),
                                          testing::Values(Space{"sRGB", reference::from_srgb}, Space{"P3", p3_colour},
                                                          Space{"ACEScg", acescg_colour})),
                         [](const auto& which) {
                             return std::get<1>(which.param).name + std::string("Under") + std::get<0>(which.param);
                         });

}  // namespace
}  // namespace nacre::test
