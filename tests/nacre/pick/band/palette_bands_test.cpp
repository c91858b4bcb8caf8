// The bands of one pick and of several. What a band looks like is judged by the reference model.
// NACRE_PICK_SWEEP=1 takes 1000 palettes and 1000 colours.
#include "nacre/pick/band/palette_bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "nacre/pick/band/picked_bands.h"

namespace nacre::test {
namespace {

const PickLight& daylight() {
    static const PickLight light("D65");
    return light;
}

Xyz srgb(double r, double g, double b) {
    return as_xyz(reference::from_srgb({r, g, b}));
}

bool is_notch(const Lobe& lobe) {
    return lobe.floor > lobe.height;
}

struct Uv2 {
    double u, v;
};
Uv2 chromaticity(const reference::Triple& c) {
    const double sum = c[0] + 15.0 * c[1] + 3.0 * c[2];
    return {4.0 * c[0] / sum, 9.0 * c[1] / sum};
}

// All bands of floor 0 and one flatness: a dense grid of peaks in the light's range and of widths up to a metre's
// millionth, which are the widths that there are. A counterexample is refined until it has the colour's chromaticity.
class BandsOfFlatness {
public:
    BandsOfFlatness(const PickLight& light, double flatness) : light_(light), flatness_(flatness) {
        for (int i = 0; i < peaks; ++i)
            for (int j = 0; j < widths; ++j) uvs_.push_back(uv_at(peak_of(i), root_of(j)));
    }

    struct Found {
        double peak_nm, width_nm, luminance;
    };

    // Every band of the chromaticity that the grid leads to.
    std::vector<Found> of(Uv2 target) const {
        std::vector<Found> found;
        for (int i = 0; i + 1 < peaks; ++i) {
            for (int j = 0; j + 1 < widths; ++j) {
                const Uv2 &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
                if (holds(a, b, c, target) || holds(d, b, c, target)) refine(i, j, target, found);
            }
        }
        return found;
    }

private:
    static constexpr int peaks = 95, widths = 50;
    static double peak_of(double i) { return 360.0 + 5.0 * i; }
    static double root_of(double j) { return 0.02 + 0.02 * j; }  // of the width in micrometres
    const Uv2& at(int i, int j) const { return uvs_[static_cast<std::size_t>(i * widths + j)]; }
    Uv2 uv_at(double peak_nm, double root) const {
        return chromaticity(light_.integral(peak_nm, 1000.0 * root * root, flatness_));
    }
    static bool holds(const Uv2& a, const Uv2& b, const Uv2& c, Uv2 t) {
        const double area = (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
        const double beta = ((t.u - a.u) * (c.v - a.v) - (c.u - a.u) * (t.v - a.v)) / area;
        const double gamma = ((b.u - a.u) * (t.v - a.v) - (t.u - a.u) * (b.v - a.v)) / area;
        return beta > -0.1 && gamma > -0.1 && beta + gamma < 1.1;
    }
    void refine(int i, int j, Uv2 target, std::vector<Found>& found) const {
        double peak_nm = peak_of(i + 0.5), root = root_of(j + 0.5);
        for (int step = 0; step < 20; ++step) {
            const Uv2 here = uv_at(peak_nm, root);
            const double du = target.u - here.u, dv = target.v - here.v;
            if (std::abs(du) + std::abs(dv) < 1e-10) {
                const double width_nm = 1000.0 * root * root;
                found.push_back({peak_nm, width_nm, light_.integral(peak_nm, width_nm, flatness_)[1]});
                return;
            }
            const Uv2 p = uv_at(peak_nm + 1e-3, root), q = uv_at(peak_nm, root - 1e-5);
            const double pu = (p.u - here.u) / 1e-3, pv = (p.v - here.v) / 1e-3;
            const double qu = (q.u - here.u) / -1e-5, qv = (q.v - here.v) / -1e-5;
            const double area = pu * qv - qu * pv;
            peak_nm += std::clamp((du * qv - qu * dv) / area, -10.0, 10.0);
            root += std::clamp((pu * dv - du * pv) / area, -0.04, 0.04);
            if (!(peak_nm >= 360.0 && peak_nm <= 830.0 && root >= 0.01 && root <= 1.0)) return;
        }
    }

    const PickLight& light_;
    double flatness_;
    std::vector<Uv2> uvs_;
};

// One pick: what is worse about an answer than about a band found by brute force.
class OnePickRule {
public:
    explicit OnePickRule(const PickLight& light) : light_(light) {
        for (int i = 0; i < 20; ++i) tables_.emplace_back(0.05 * i, BandsOfFlatness(light, 0.05 * i));
        for (const double most : {0.97, 0.99, 0.999}) tables_.emplace_back(most, BandsOfFlatness(light, most));
    }

    // @return what is better; empty if nothing is
    std::string better_than(const Lobe& answer, const reference::Triple& colour) const {
        const Uv2 target = chromaticity(colour);
        const double below = is_notch(answer) ? 1.0 : answer.flatness - 0.01;
        for (const auto& [flatness, table] : tables_) {
            if (flatness > below) continue;
            if (std::string band = bright_band(table, flatness, target, colour[1], 0.0); !band.empty()) return band;
        }
        if (!is_notch(answer) && below > 0.0)
            return bright_band(BandsOfFlatness(light_, below), below, target, colour[1], 0.0);
        if (is_notch(answer) || answer.flatness > 0.0) return {};
        return bright_band(tables_[0].second, 0.0, target, colour[1], answer.width_nm + 1.0);
    }

private:
    // A ten thousandth is for brightness that is only just enough.
    static bool is_bright_enough(const BandsOfFlatness::Found& band, double luminance) {
        return luminance / band.luminance <= 1.0 - 1e-4;
    }
    static std::string bright_band(const BandsOfFlatness& table, double flatness, Uv2 target, double luminance,
                                   double wider_than_nm) {
        for (const auto& band : table.of(target)) {
            if (is_bright_enough(band, luminance) && band.width_nm > wider_than_nm)
                return text_of(Lobe{band.peak_nm, band.width_nm, luminance / band.luminance, 0.0, flatness});
        }
        return {};
    }

    const PickLight& light_;
    std::vector<std::pair<double, BandsOfFlatness>> tables_;
};

TEST(OnePickBand, HasNoFloorTheLeastFlatnessThenTheGreatestWidthAndIsANotchOnlyWhereItMust) {
    const OnePickRule rule(daylight());
    reference::Dice dice(4);
    Failures failures;
    int notches = 0, flat = 0;
    const int count = sweeps_all_picks() ? 1000 : 100;
    for (int i = 0; i < count; ++i) {
        const auto rgb = random_rgb(dice);
        const Xyz colour = srgb(rgb[0], rgb[1], rgb[2]);
        const Lobe band = daylight().only_band(colour);
        EXPECT_EQ(is_notch(band) ? band.height : band.floor, 0.0);
        notches += is_notch(band);
        flat += band.flatness > 0.0;
        const std::string better = rule.better_than(band, daylight().model.seen_as(as_model(colour)));
        if (better.empty()) continue;
        char name[100];
        std::snprintf(name, sizeof name, "[%.17g, %.17g, %.17g]", rgb[0], rgb[1], rgb[2]);
        failures.add(std::string(name) + " is " + text_of(band) + ", could be " + better);
    }
    EXPECT_EQ(failures.count, 0) << "of " << count << ", such as" << failures.first.str();
    EXPECT_GT(notches, count / 20);
    EXPECT_GT(flat, count / 20);
}

// Bands of nearly grey are wider than what is seen: their peak may run without being seen.
bool says_where(const Lobe& band) {
    return band.width_nm < 500.0;
}

// Short walks through sRGB. Bands change from one family to another somewhere, and a notch has to become a band; that
// is a surface in the space of colours, which a walk crosses once.
TEST(OnePickBand, OfNeighbouringColoursAreNeighboursButWhereAFamilyEnds) {
    constexpr int walks = 200, steps = 16;
    constexpr double step_length = 1.0 / 512.0, jump_nm = 20.0;
    reference::Dice dice(5);
    Failures twice;
    int jumps = 0, between_kinds = 0;
    for (int walk = 0; walk < walks; ++walk) {
        std::array<double, 3> from{}, way{};
        for (double& component : from) component = dice.between(0.05, 0.95);
        for (double& component : way) component = dice.between(-1.0, 1.0);
        const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        Lobe before;
        int jumps_of_walk = 0;
        for (int step = 0; step <= steps; ++step) {
            const double t = step * step_length / length;
            const Lobe band =
                daylight().only_band(srgb(from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]));
            if (step > 0 && std::abs(band.peak_nm - before.peak_nm) > jump_nm && says_where(band) &&
                says_where(before)) {
                ++jumps_of_walk;
                between_kinds += is_notch(band) != is_notch(before);
                if (jumps_of_walk > 1) twice.add(text_of(before) + " to " + text_of(band));
            }
            before = band;
        }
        jumps += jumps_of_walk;
    }
    RecordProperty("jumps", jumps);
    RecordProperty("between_kinds", between_kinds);
    // At most one step in a hundred, and no walk that goes to and fro.
    EXPECT_LE(jumps, walks * steps / 100) << between_kinds << " of them between a band and a notch";
    EXPECT_EQ(twice.count, 0) << twice.first.str();
}

std::vector<ColourOrBand> random_picks(reference::Dice& dice) {
    std::vector<ColourOrBand> picks(static_cast<std::size_t>(dice.whole(2, 3)));
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const auto rgb = random_rgb(dice);
        picks[i] = {25.0 * static_cast<double>(i) + dice.between(0.0, 20.0), srgb(rgb[0], rgb[1], rgb[2]), {}};
    }
    return picks;
}

TEST(PaletteBands, HaveTheColoursOfTheirPicksInWhateverOrder) {
    const PickLight again("D65");
    reference::Dice dice(6);
    Failures failures;
    const int count = sweeps_all_picks() ? 1000 : 100;
    for (int i = 0; i < count; ++i) {
        std::vector<ColourOrBand> picks = random_picks(dice);
        std::vector<Lobe> bands = palette_bands(daylight().bands, daylight().core, picks);
        ASSERT_EQ(bands.size(), picks.size());
        for (std::size_t k = 0; k < picks.size(); ++k) {
            const double miss = daylight().difference(bands[k], *picks[k].colour);
            if (!(miss <= 0.01) || !is_a_reflectance(bands[k]))
                failures.add(std::to_string(i) + ": " + text_of(bands[k]) + " misses by " + std::to_string(miss));
        }
        EXPECT_EQ(palette_bands(again.bands, again.core, picks), bands) << i;
        std::rotate(picks.begin(), picks.begin() + 1, picks.end());
        std::rotate(bands.begin(), bands.begin() + 1, bands.end());
        EXPECT_EQ(palette_bands(daylight().bands, daylight().core, picks), bands) << i;
    }
    EXPECT_EQ(failures.count, 0) << "of " << count << ", such as" << failures.first.str();
}

TEST(PaletteBands, OfBlackAndGreyTakePeakAndWidthOfANeighbour) {
    const Xyz black{}, grey = srgb(0.5, 0.5, 0.5), green = srgb(0.1, 0.7, 0.2), blue = srgb(0.1, 0.2, 0.8);
    const auto bands =
        palette_bands(daylight().bands, daylight().core,
                      {{0.0, black, {}}, {20.0, green, {}}, {40.0, grey, {}}, {60.0, blue, {}}, {80.0, black, {}}});
    ASSERT_EQ(bands.size(), 5u);
    const auto is_like = [](const Lobe& one, const Lobe& other) {
        return one.peak_nm == other.peak_nm && one.width_nm == other.width_nm;
    };
    EXPECT_TRUE(is_like(bands[0], bands[1]));
    EXPECT_TRUE(is_like(bands[2], bands[1]) || is_like(bands[2], bands[3]));
    EXPECT_TRUE(is_like(bands[4], bands[3]));
    for (const std::size_t i : {0U, 4U}) EXPECT_EQ(std::max(bands[i].height, bands[i].floor), 0.0);
    EXPECT_NEAR(bands[2].height, grey.y, 1e-8);
    EXPECT_EQ(bands[2].height, bands[2].floor);
    EXPECT_LE(daylight().difference(bands[1], green), 0.01);
    EXPECT_LE(daylight().difference(bands[2], grey), 0.01);
    EXPECT_LE(daylight().difference(bands[3], blue), 0.01);
}

TEST(PaletteBands, OfGreysAloneAreGrey) {
    const std::vector<ColourOrBand> picks{
        {0.0, srgb(0.2, 0.2, 0.2), {}}, {30.0, Xyz{}, {}}, {60.0, srgb(1.0, 1.0, 1.0), {}}};
    const auto bands = palette_bands(daylight().bands, daylight().core, picks);
    for (std::size_t i = 0; i < picks.size(); ++i) {
        EXPECT_EQ(bands[i].height, bands[i].floor);
        EXPECT_LE(daylight().difference(bands[i], *picks[i].colour), 0.01);
        EXPECT_TRUE(is_a_reflectance(bands[i])) << text_of(bands[i]);
    }
}

TEST(PaletteBands, ThatAreGivenStayAsTheyAre) {
    const Lobe given{610.0, 140.0, 0.7, 0.1, 0.3}, other{450.0, 60.0, 0.2, 0.8, 0.0};
    const Xyz green = srgb(0.1, 0.7, 0.2);
    const auto bands =
        palette_bands(daylight().bands, daylight().core, {{50.0, {}, given}, {0.0, green, {}}, {70.0, {}, other}});
    EXPECT_EQ(bands[0], given);
    EXPECT_EQ(bands[2], other);
    EXPECT_LE(daylight().difference(bands[1], green), 0.01);
    EXPECT_EQ(palette_bands(daylight().bands, daylight().core, {{50.0, {}, given}}).at(0), given);
}

}  // namespace
}  // namespace nacre::test
