#include "nacre/lut/gamut_compression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/observer.h"
#include "nacre/colour/oklab.h"
#include "nacre/colour/rgb_space.h"

namespace nacre {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array spaces{"lin_rec709_scene",  "lin_p3d65_scene", "lin_adobergb_scene",
                            "lin_rec2020_scene", "lin_ap1_scene",   "lin_ap0_scene"};

// To the space's RGB from XYZ of D65, its white at (1, 1, 1).
glm::dmat3 rgb_of_xyz(const std::string& space) {
    const RgbPrimaries primaries = *primaries_by_interop_id(space);
    return xyz_to_rgb_matrix(primaries) *
           adaptation_matrix(Adaptation::bradford, d65_white, xyz_from_chromaticity(primaries.white));
}

Rgb rgb_of(const glm::dmat3& matrix, Xyz colour) {
    const Xyz rgb = adapt(matrix, colour);
    return {rgb.x, rgb.y, rgb.z};
}

double smallest(Rgb c) {
    return std::min({c.r, c.g, c.b});
}

double hue(const Oklab& lab) {
    return std::atan2(lab.b, lab.a);
}

double saturation(const Oklab& lab) {
    return std::hypot(lab.a, lab.b) / lab.lightness;
}

struct Space {
    explicit Space(const std::string& name) : to_rgb(rgb_of_xyz(name)), from_rgb(glm::inverse(to_rgb)), fit(to_rgb) {}
    Rgb fitted(Xyz colour) const { return fit(rgb_of(to_rgb, colour), colour); }
    Oklab fitted_lab(Xyz colour) const {
        const Rgb c = fitted(colour);
        return xyz_to_oklab(adapt(from_rgb, {c.r, c.g, c.b}));
    }
    glm::dmat3 to_rgb, from_rgb;
    GamutCompression fit;
};

Xyz spectral(double nm) {
    const int low = std::min(static_cast<int>(nm), 829);
    const auto& a = colour_matching(Observer::cie1931_2deg, low);
    const auto& b = colour_matching(Observer::cie1931_2deg, low + 1);
    const double t = nm - low;
    return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)};
}

// Sums of light of three wavelengths and white, of any brightness up to that of a grating.
std::vector<Xyz> real_colours(std::size_t count) {
    std::mt19937_64 engine(20);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    std::vector<Xyz> colours;
    while (colours.size() < count) {
        Xyz sum = xyz_from_chromaticity(d65_chromaticity, std::pow(uniform(), 4.0));
        for (int i = 0; i < 3; ++i) {
            const Xyz one = spectral(400.0 + 300.0 * uniform());
            const double power = 4.0 * std::pow(uniform(), 6.0);
            sum = {sum.x + power * one.x, sum.y + power * one.y, sum.z + power * one.z};
        }
        colours.push_back(sum);
    }
    return colours;
}

TEST(GamutCompression, KeepsHueAndLightnessOfTenThousandColoursAndLeavesNothingNegative) {
    const std::vector<Xyz> colours = real_colours(10000);
    for (const char* name : spaces) {
        const Space space(name);
        int bent = 0, outside = 0;
        for (const Xyz& colour : colours) {
            const Oklab before = xyz_to_oklab(colour), after = space.fitted_lab(colour);
            EXPECT_GE(smallest(space.fitted(colour)), 0.0) << name;
            EXPECT_NEAR(after.lightness, before.lightness, 1e-12) << name;
            const double turn = std::remainder(hue(after) - hue(before), 2.0 * std::numbers::pi);
            EXPECT_LT(std::abs(turn) * std::hypot(before.a, before.b), 1e-10) << name;
            if (saturation(before) > 1e-3) {
                EXPECT_LT(std::abs(turn), 1e-6) << name;
            }
            EXPECT_LE(saturation(after), saturation(before) + 1e-12) << name;
            bent += saturation(after) < saturation(before) - 1e-6 ? 1 : 0;
            outside += smallest(rgb_of(space.to_rgb, colour)) < -1e-6 ? 1 : 0;
        }
        EXPECT_GE(bent, outside) << name;
        EXPECT_GT(outside, std::string(name) == spaces.front() ? 4000 : -1);
    }
}

TEST(GamutCompression, LeavesEveryBitOfWhatLiesWellInside) {
    for (const char* name : spaces) {
        const Space space(name);
        std::size_t inside = 0;
        for (const Xyz& colour : real_colours(10000)) {
            const Oklab lab = xyz_to_oklab(colour);
            if (saturation(lab) > 0.8 * space.fit.bound(lab.a, lab.b).edge) continue;
            ++inside;
            EXPECT_EQ(space.fitted(colour), rgb_of(space.to_rgb, colour)) << name;
        }
        EXPECT_GT(inside, 1000U) << name;
    }
}

TEST(GamutCompression, KeepsGreyExactly) {
    const Space space("lin_rec709_scene");
    for (const double y : {0.0, 1e-9, 0.18, 1.0, 40.0}) {
        const Xyz grey = xyz_from_chromaticity(d65_chromaticity, y);
        EXPECT_EQ(space.fit({y, y, y}, grey), (Rgb{y, y, y}));
    }
}

// A second road to the hull: along the hue until a component is negative, with the matrices as Ottosson printed them.
double hull_by_bisection(const glm::dmat3& to_rgb, double hue_rad) {
    const glm::dmat3 cones =
        glm::transpose(glm::dmat3{0.8189330101, 0.3618667424, -0.1288597137, 0.0329845436, 0.9293118715, 0.0361456387,
                                  0.0482003018, 0.2643662691, 0.6338517070});
    const glm::dmat3 lab =
        glm::transpose(glm::dmat3{0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099,
                                  0.0259040371, 0.7827717662, -0.8086757660});
    const auto is_inside = [&](double s) {
        const glm::dvec3 root = glm::inverse(lab) * glm::dvec3{1.0, s * std::cos(hue_rad), s * std::sin(hue_rad)};
        const glm::dvec3 rgb = to_rgb * (glm::inverse(cones) * (root * root * root));
        return rgb.x >= 0.0 && rgb.y >= 0.0 && rgb.z >= 0.0;
    };
    double low = 0.0;
    while (low < 2.0 && is_inside(low + 1e-3)) low += 1e-3;
    double high = low + 1e-3;
    for (int i = 0; i < 40; ++i) (is_inside(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    return low;
}

TEST(GamutCompression, EdgeIsTheHullExceptAtItsCornersAndNeverBeyond) {
    for (const char* name : {"lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"}) {
        const Space space(name);
        int at_corners = 0;
        for (int tenths = 0; tenths < 3600; tenths += 7) {
            const double hue_rad = 0.1 * tenths * degree;
            const double edge = space.fit.bound(std::cos(hue_rad), std::sin(hue_rad)).edge;
            const double hull = hull_by_bisection(space.to_rgb, hue_rad);
            EXPECT_LE(edge, hull) << name << " " << 0.1 * tenths;
            at_corners += edge < 0.998 * hull ? 1 : 0;
        }
        EXPECT_LT(at_corners, 0.15 * 3600 / 7) << name;
        EXPECT_GT(at_corners, 0) << name;
    }
}

TEST(GamutCompression, EdgeTurnsWithHueWithoutCornersOrJumps) {
    for (const char* name : spaces) {
        const Space space(name);
        const auto edge = [&](double hue_deg) {
            return std::log(space.fit.bound(std::cos(hue_deg * degree), std::sin(hue_deg * degree)).edge);
        };
        for (double hue_deg = 0.0; hue_deg < 360.0; hue_deg += 0.25) {
            EXPECT_LT(std::abs(edge(hue_deg + 0.25) - edge(hue_deg)), 0.05) << name << " " << hue_deg;
            // Sticks out by no more than the parabola that loses 1 % within the first degree.
            EXPECT_GT(edge(hue_deg + 1.0) - 2.0 * edge(hue_deg) + edge(hue_deg - 1.0), -0.021)
                << name << " " << hue_deg;
        }
    }
}

TEST(GamutCompression, MoreSaturatedStaysMoreSaturated) {
    for (const char* name : spaces) {
        const Space space(name);
        for (int hue_deg = 0; hue_deg < 360; ++hue_deg) {
            double before = -1.0;
            for (double s = 0.0; s < 1.2; s += 0.01) {
                const Oklab lab{0.6, 0.6 * s * std::cos(hue_deg * degree), 0.6 * s * std::sin(hue_deg * degree)};
                const double after = saturation(space.fitted_lab(oklab_to_xyz(lab)));
                // Where there is no room to speak of, what lies beyond the edge ends on it; back from RGB, the cube
                // root of a cone that hardly responds to a yellow of ACES2065-1 magnifies rounding.
                if (space.fit.bound(lab.a, lab.b).room > 0.1) {
                    EXPECT_GT(after, before) << name << " " << hue_deg << " " << s;
                } else {
                    EXPECT_GT(after, before - 1e-6) << name << " " << hue_deg << " " << s;
                }
                before = after;
            }
        }
    }
}

// Around the spectrum, from grey outwards, and everything in between: a small step stays one.
TEST(GamutCompression, SmallStepsStaySmall) {
    constexpr double step = 1e-6;
    const auto distance = [](const Oklab& p, const Oklab& q) {
        return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b);
    };
    for (const char* name : spaces) {
        const Space space(name);
        double largest = 0.0;
        for (const Xyz& colour : real_colours(3000)) {
            const Oklab lab = xyz_to_oklab(colour);
            const Oklab fitted = space.fitted_lab(colour);
            for (const Oklab& other : {Oklab{lab.lightness + step, lab.a, lab.b},
                                       {lab.lightness, lab.a + step, lab.b},
                                       {lab.lightness, lab.a, lab.b + step}}) {
                largest = std::max(largest, distance(space.fitted_lab(oklab_to_xyz(other)), fitted) / step);
            }
        }
        // The edge changes by up to 12 % per degree of hue, 7 times as much per radian, and a little goes with
        // lightness.
        EXPECT_LT(largest, 8.0) << name;
        EXPECT_GT(largest, 0.9) << name;
    }
}

TEST(GamutCompression, CommutesWithExposure) {
    const Space space("lin_rec709_scene");
    for (const Xyz& colour : real_colours(1000)) {
        const Rgb one = space.fitted(colour);
        const Rgb brighter = space.fitted({8.0 * colour.x, 8.0 * colour.y, 8.0 * colour.z});
        const double size = std::max({brighter.r, brighter.g, brighter.b});
        EXPECT_NEAR(brighter.r, 8.0 * one.r, 1e-12 * size);
        EXPECT_NEAR(brighter.g, 8.0 * one.g, 1e-12 * size);
        EXPECT_NEAR(brighter.b, 8.0 * one.b, 1e-12 * size);
    }
}

TEST(GamutCompression, SpaceThatHoldsEveryColourIsHardlyBent) {
    const Space space("lin_ap0_scene");
    for (int nm = 460; nm <= 640; ++nm) {
        const Oklab before = xyz_to_oklab(spectral(nm));
        const Oklab after = space.fitted_lab(spectral(nm));
        EXPECT_NEAR(saturation(after), saturation(before), 0.01 * saturation(before)) << nm;
    }
    for (const double nm : {470.0, 490.0, 520.0, 560.0}) {
        EXPECT_EQ(space.fitted(spectral(nm)), rgb_of(space.to_rgb, spectral(nm))) << nm;
    }
}

TEST(GamutCompression, VioletStaysVioletAndIsNotBlack) {
    const Space space("lin_rec709_scene");
    for (int nm = 410; nm <= 450; nm += 10) {
        const Xyz violet = spectral(nm);
        const Rgb fitted = space.fitted(violet);
        EXPECT_GT(fitted.b, 0.2 * rgb_of(space.to_rgb, violet).b) << nm;
        EXPECT_GT(fitted.b, 3.0 * fitted.r) << nm;
        EXPECT_GT(fitted.r, 20.0 * fitted.g) << nm;
    }
}

TEST(GamutCompression, AnythingAtAllBecomesACleanColour) {
    constexpr double tiny = std::numeric_limits<double>::denorm_min(), huge = 1e300;
    for (const char* name : spaces) {
        const Space space(name);
        for (const Xyz& colour : {Xyz{},
                                  {1.0, 0.0, 0.0},
                                  {0.0, 1.0, 0.0},
                                  {0.0, 0.0, 1.0},
                                  {-1.0, -1.0, -1.0},
                                  {0.2, -0.1, 0.9},
                                  {tiny, tiny, tiny},
                                  {0.0, 0.0, tiny},
                                  {0.1 * huge, 0.1 * huge, huge}}) {
            const Rgb fitted = space.fitted(colour);
            for (const double component : {fitted.r, fitted.g, fitted.b}) {
                EXPECT_TRUE(std::isfinite(component)) << name;
                EXPECT_FALSE(std::signbit(component)) << name;
            }
        }
    }
}

TEST(GamutCompression, CurveIsAscendingSmoothAndEndsBelowTheEdge) {
    for (const double room : {0.01, 0.1, 0.2}) {
        const double knee = 1.0 - room;
        EXPECT_EQ(GamutCompression::nearer(knee, room), knee);
        EXPECT_NEAR(GamutCompression::nearer(1.0, room), knee + room / std::sqrt(2.0), 1e-15);
        EXPECT_EQ(GamutCompression::nearer(std::numeric_limits<double>::infinity(), room), 1.0);
        for (double d = 0.01; d < 3.0; d += 0.01) {
            EXPECT_GT(GamutCompression::nearer(d, room), GamutCompression::nearer(d - 0.01, room));
            EXPECT_LE(GamutCompression::nearer(d, room), d);
            EXPECT_LT(GamutCompression::nearer(d, room), 1.0);
        }
        const double h = 1e-4 * room;
        const auto slope = [&](double d) {
            return (GamutCompression::nearer(d + h, room) - GamutCompression::nearer(d, room)) / h;
        };
        EXPECT_NEAR(slope(knee), 1.0, 1e-6);
    }
    EXPECT_EQ(GamutCompression::nearer(0.99, 0.0), 0.99);
    EXPECT_EQ(GamutCompression::nearer(1.01, 0.0), 1.0);
}

}  // namespace
}  // namespace nacre
