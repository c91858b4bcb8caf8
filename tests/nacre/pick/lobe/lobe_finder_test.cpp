// Colours to lobes: lobes come back, and what no lobe has is as near as an exhaustive search of all lobes finds.
#include "nacre/pick/lobe/lobe_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "io/ceres_solver.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/pick/lobe/many_differences.h"

namespace nacre {
namespace {

Light light_of(const std::string& illuminant) {
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.power = *illuminant_by_name(illuminant);
    return make_light(settings);
}

const Light& daylight() {
    static const Light light = light_of("D65");
    return light;
}

const LobeFinder& finder() {
    static const LobeFinder finder(daylight().weights, daylight().moments, daylight().adaptation,
                                   least_squares_solver());
    return finder;
}

// The same on every platform.
class Random {
public:
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(generator_()) / 4294967296.0);
    }

private:
    std::mt19937 generator_{11};
};

Xyz colour_of(const Light& light, double peak_nm, double width_nm, double height) {
    return adapt(light.adaptation, lobe_to_xyz_per_cell(light.weights, peak_nm, width_nm, height));
}

double difference(const Xyz& one, const Xyz& other) {
    return ciede2000(to_lab(one, d65_white), to_lab(other, d65_white));
}

// IEC 61966-2-1.
Xyz random_srgb(Random& random) {
    std::array<double, 3> linear{};
    for (double& component : linear) {
        const double value = random.between(0.0, 1.0);
        component = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    const auto [r, g, b] = linear;
    return {0.4123908 * r + 0.3575843 * g + 0.1804808 * b, 0.2126390 * r + 0.7151687 * g + 0.0721923 * b,
            0.0193308 * r + 0.1191948 * g + 0.9505322 * b};
}

class LobeFinderUnder : public testing::TestWithParam<const char*> {};

TEST_P(LobeFinderUnder, TakesRandomLobesBackToTheirColour) {
    const Light light = light_of(GetParam());
    const LobeFinder under(light.weights, light.moments, light.adaptation, least_squares_solver());
    Random random;
    for (int i = 0; i < 10000; ++i) {
        const double peak_nm = random.between(380.0, 780.0);
        const double width_nm = std::exp(random.between(std::log(5.0), std::log(1000.0)));
        const double height = random.between(0.0, 1.0);
        const Xyz colour = colour_of(light, peak_nm, width_nm, height);
        const LobeMatch match = under.find(colour);
        const std::string what = "lobe " + std::to_string(peak_nm) + " " + std::to_string(width_nm) + " " +
                                 std::to_string(height) + ", Y " + std::to_string(colour.y);
        ASSERT_EQ(match.miss, LobeMiss::none) << what << ", off by " << match.de00;
        const Xyz found = colour_of(light, match.peak_nm, match.width_nm, match.height);
        ASSERT_LE(difference(colour, found), exact_lobe_de00) << what;
        ASSERT_NEAR(difference(colour, found), match.de00, 1e-3) << what;
        ASSERT_TRUE(match.height >= 0.0 && match.height <= 1.0 && match.width_nm >= 0.0 && match.width_nm <= 1000.0);
        // Narrow ones, and red beyond, have the locus's chromaticity, whatever their width.
        if (peak_nm < 680.0 && peak_nm > 430.0 && width_nm > 120.0) {
            ASSERT_GE(match.width_nm, 0.97 * width_nm) << what << ": the widest is asked for";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Lights, LobeFinderUnder, testing::Values("D65", "A", "E"),
                         [](const auto& light) { return std::string(light.param); });

// Every lobe of a fine table at every height of a fine ladder, by squares of differences.
class Exhaustive {
public:
    Exhaustive() {
        const Light& light = daylight();
        for (double peak_nm = 360.0; peak_nm <= 830.0; peak_nm += 5.0) {
            for (double spread = 0.03; spread <= 1.0; spread += 0.0194) {
                const Xyz unit = adapt(light.adaptation, lobe_to_xyz_fast(light.weights, light.moments, peak_nm,
                                                                          1000.0 * spread * spread, 1.0));
                for (double height = 0.04; height < 1.001; height += 0.04) {
                    colours_.push_back({height * unit.x, height * unit.y, height * unit.z});
                    for (std::size_t i = 0; i < 3; ++i) {
                        const std::array values{unit.x / white_.x, unit.y, unit.z / white_.z};
                        roots_[i].push_back(static_cast<float>(std::cbrt(values[i])));
                    }
                    factors_.push_back(static_cast<float>(std::cbrt(height)));
                }
            }
        }
        for (std::vector<float>* row : {&roots_[0], &roots_[1], &roots_[2], &factors_})
            row->resize(row->size() + RootColours::padding, 1.0F);
        squares_.resize(factors_.size());
    }

    double nearest(const Xyz& colour) {
        const Lab lab = to_lab(colour, white_);
        many_differences(lab, {roots_[0].data(), roots_[1].data(), roots_[2].data(), factors_.data(), colours_.size()},
                         squares_.data());
        const auto end = squares_.begin() + static_cast<std::ptrdiff_t>(colours_.size());
        const auto least = std::min_element(squares_.begin(), end) - squares_.begin();
        // Twice, because nobody checks the checker.
        return difference(colour, colours_[static_cast<std::size_t>(least)]);
    }

private:
    Xyz white_ = d65_white;
    std::vector<Xyz> colours_;
    std::array<std::vector<float>, 3> roots_;
    std::vector<float> factors_;
    std::vector<float> squares_;
};

// Where hues are opposite CIEDE2000 jumps: the worst difference to the lobe as it is printed, and to colours that
// single precision does not tell from the target.
double if_rounded(const Xyz& colour, const LobeMatch& match) {
    const auto rounded = [](double value, double step) { return std::round(value / step) * step; };
    const Lab target = to_lab(colour, d65_white);
    const Lab exact = to_lab(colour_of(daylight(), match.peak_nm, match.width_nm, match.height), d65_white);
    const Lab printed = to_lab(
        colour_of(daylight(), rounded(match.peak_nm, 0.001), rounded(match.width_nm, 0.001), match.height), d65_white);
    double worst = 0.0;
    for (const double step : {-1e-3, 1e-3}) {
        for (const Lab& lab : {exact, printed}) {
            worst = std::max({worst, ciede2000({target.l, target.a + step, target.b}, lab),
                              ciede2000({target.l, target.a, target.b + step}, lab)});
        }
    }
    return worst;
}

TEST(LobeFinder, IsAsNearAsAnExhaustiveSearch) {
    Exhaustive exhaustive;
    Random random;
    int missed = 0;
    double gained = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const Xyz colour = random_srgb(random);
        const LobeMatch match = finder().find(colour);
        ASSERT_NEAR(difference(colour, colour_of(daylight(), match.peak_nm, match.width_nm, match.height)), match.de00,
                    1e-3);
        if (match.miss == LobeMiss::none) continue;
        ++missed;
        const double nearest = exhaustive.nearest(colour);
        EXPECT_LE(match.de00, nearest + 0.05) << colour.x << " " << colour.y << " " << colour.z;
        EXPECT_LE(if_rounded(colour, match), match.de00 + 0.05) << colour.x << " " << colour.y << " " << colour.z;
        gained += nearest - match.de00;
    }
    EXPECT_GT(missed, 5000);
    EXPECT_GT(gained / missed, 0.05) << "the table's steps";
}

// Colours that a search goes astray at: next to grey's opposite hues, where CIEDE2000 jumps by half of itself; dark,
// where lobes as light as they are are all too colourful; blues and reds whose lobes end out of sight.
TEST(LobeFinder, IsNotLedAstray) {
    Exhaustive exhaustive;
    for (const Lab& lab : {Lab{58.7, 53.0, 8.0},
                           {33.7, 25.4, 2.2},
                           {40.1, 35.1, 5.0},
                           {66.2, 35.5, 14.2},
                           {28.1, 37.4, -2.5},
                           {15.4, 9.5, 4.4},
                           {10.6, 14.7, 4.9},
                           {2.0, 0.6, -3.4},
                           {5.5, 16.8, -27.6},
                           {63.5, -3.7, -51.5},
                           {48.6, 24.6, -61.3},
                           {62.1, 20.6, 55.1},
                           {57.57, -9.13, -41.68},
                           {37.15, 38.44, 8.11},
                           {54.25, 19.38, 50.27},
                           {65.98, 5.81, -1.46},
                           {66.11, 38.83, 5.63},
                           {52.521174993, 33.184541041, 9.905457885},
                           {25.443253643, 13.896779266, -16.090696142}}) {
        const Xyz colour = from_lab(lab, d65_white);
        const LobeMatch match = finder().find(colour);
        EXPECT_NEAR(difference(colour, colour_of(daylight(), match.peak_nm, match.width_nm, match.height)), match.de00,
                    1e-3);
        EXPECT_LE(match.de00, exhaustive.nearest(colour) + 0.05) << lab.l << " " << lab.a << " " << lab.b;
        EXPECT_LE(if_rounded(colour, match), match.de00 + 0.05) << lab.l << " " << lab.a << " " << lab.b;
    }
}

// configs/picking.md says so.
TEST(LobeFinder, HasTwoFifthsOfSrgb) {
    Random random;
    int exact = 0;
    for (int i = 0; i < 2000; ++i) exact += finder().find(random_srgb(random)).miss == LobeMiss::none ? 1 : 0;
    EXPECT_NEAR(exact / 2000.0, 0.43, 0.03);
}

TEST(LobeFinder, HasAnAnswerForWhatIsNoSurfacesColour) {
    const LobeMatch black = finder().find({});
    EXPECT_EQ(black.height, 0.0);
    EXPECT_EQ(black.de00, 0.0);
    EXPECT_EQ(black.miss, LobeMiss::none);
    // The widest lobe there is falls towards both ends: next to white, never white.
    const LobeMatch brightest = finder().find(d65_white);
    EXPECT_NE(brightest.miss, LobeMiss::none);
    EXPECT_LT(brightest.de00, 15.0);
    EXPECT_GT(brightest.width_nm, 800.0);
    // A green that glows.
    const Xyz green = colour_of(daylight(), 540.0, 100.0, 1.0);
    const LobeMatch glowing = finder().find({1.5 * green.x, 1.5 * green.y, 1.5 * green.z});
    EXPECT_EQ(glowing.miss, LobeMiss::bright);
    EXPECT_GT(glowing.de00, 1.0);
    const LobeMatch purple = finder().find({0.3, 0.12, 0.3});
    EXPECT_EQ(purple.miss, LobeMiss::saturated);
    for (const Xyz& colour : {Xyz{-0.1, 0.1, 0.2},
                              {0.1, -0.2, 0.1},
                              {1e4, 1e4, 1e4},
                              {1e-9, 1e-9, 1e-9},
                              {0.0, 0.0, 1.0},
                              {1.0, 0.0, 0.0},
                              {-5.0, -5.0, -5.0}}) {
        const LobeMatch match = finder().find(colour);
        EXPECT_TRUE(std::isfinite(match.de00));
        EXPECT_TRUE(match.height >= 0.0 && match.height <= 1.0);
        EXPECT_TRUE(match.width_nm >= 0.0 && match.width_nm <= 1000.0);
        EXPECT_TRUE(match.peak_nm >= 360.0 && match.peak_nm <= 830.0);
    }
}

TEST(LobeFinder, DoesWithoutASolver) {
    const Light light = light_of("A");
    const LobeFinder bare(light.weights, light.moments, light.adaptation, nullptr);
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Xyz colour = colour_of(light, random.between(380.0, 780.0), random.between(5.0, 400.0), 1.0);
        EXPECT_LE(bare.find(colour).de00, 1.5);
    }
}

TEST(Ciede2000Parts, SumToTheDifference) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const auto lab = [&] {
            return Lab{random.between(0.0, 100.0), random.between(-90.0, 90.0), random.between(-90.0, 90.0)};
        };
        const Lab one = lab(), other = lab();
        const auto [l, c, h] = ciede2000_parts(one, other);
        EXPECT_NEAR(std::sqrt(l * l + c * c + h * h), ciede2000(one, other), 1e-11);
    }
}

// Hues that turn past the opposite: the way round that is asked for stays, and there is no jump.
TEST(Ciede2000Parts, StayOnASideWhereHuesAreOpposite) {
    const Lab one{60.0, 40.0, 5.0};
    const auto at = [&](double turn_deg, double side) {
        const double hue = std::atan2(one.b, one.a) + (180.0 + turn_deg) * std::acos(-1.0) / 180.0;
        const auto [l, c, h] = ciede2000_parts(one, {55.0, 20.0 * std::cos(hue), 20.0 * std::sin(hue)}, side);
        return std::sqrt(l * l + c * c + h * h);
    };
    constexpr double hair = 1e-6;
    EXPECT_GT(std::abs(at(-hair, 0.0) - at(hair, 0.0)), 4.0) << "CIEDE2000 itself jumps";
    for (const double side : {1.0, -1.0}) {
        EXPECT_NEAR(at(-hair, side), at(hair, side), 1e-5);
        EXPECT_EQ(at(-side * 20.0, side), at(-side * 20.0, 0.0));
        EXPECT_EQ(at(120.0, side), at(120.0, 0.0)) << "only where hues are nearly opposite";
    }
}

}  // namespace
}  // namespace nacre
