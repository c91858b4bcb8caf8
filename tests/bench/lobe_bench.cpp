// One lobe to XYZ, widths 40 to 400 nm: the exact integral and the fast one beside the sums that others make, and
// beside their scalar reference implementation. And back: a colour to its lobe, beside the nearest of a table.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "io/ceres_solver.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/cost/baselines.h"
#include "nacre/optics/lobe.h"
#include "nacre/pick/lobe/lobe_finder.h"

namespace nacre {
namespace {

const TristimulusWeights& weights() {
    static const TristimulusWeights result =
        make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("D65"));
    return result;
}

// The loop that one would write: every step_nm-th nanometre of the range, where the lobe is not zero.
Xyz plain_sum(const Lobe& lobe, int step_nm) {
    const TristimulusWeights& w = weights();
    Xyz sum;
    for (int nm = w.first_nm; nm <= w.last_nm; nm += step_nm) {
        const double r = lobe_reflectance(lobe, nm);
        if (r == 0.0) continue;
        const auto i = static_cast<std::size_t>(nm - w.first_nm);
        sum.x += r * w.x[i] * step_nm;
        sum.y += r * w.y[i] * step_nm;
        sum.z += r * w.z[i] * step_nm;
    }
    return sum;
}

template <typename ToXyz>
void over_widths(benchmark::State& state, ToXyz to_xyz) {
    std::size_t lobes = 0;
    for (auto _ : state) {
        for (double width_nm = 40.0; width_nm <= 400.0; width_nm += 3.7) {
            benchmark::DoNotOptimize(to_xyz(Lobe{450.3 + 0.5 * width_nm, width_nm, 0.8}));
            ++lobes;
        }
    }
    // What the time buys: the largest error of X, Y or Z over widths and peaks, against the closed form of every cell.
    double error = 0.0;
    double de00 = 0.0;
    for (double width_nm = 40.0; width_nm <= 400.0; width_nm += 3.7) {
        for (double peak_nm = 400.0; peak_nm <= 700.0; peak_nm += 13.7) {
            const Xyz reference = lobe_to_xyz_per_cell(weights(), peak_nm, width_nm, 1.0);
            const Xyz colour = to_xyz(Lobe{peak_nm, width_nm, 1.0});
            error = std::max({error, std::abs(colour.x - reference.x), std::abs(colour.y - reference.y),
                              std::abs(colour.z - reference.z)});
            const auto lab = [&](const Xyz& c) {
                return to_lab({c.x / reference.y, c.y / reference.y, c.z / reference.y}, weights().white);
            };
            de00 = std::max(de00, ciede2000(lab(colour), lab(reference)));
        }
    }
    state.counters["error"] = error;
    state.counters["dE00"] = de00;  // where the lobe itself is shown at Y = 1
    state.counters["per_lobe"] =
        benchmark::Counter(static_cast<double>(lobes), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void exact(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return lobe_to_xyz(weights(), l.peak_nm, l.width_nm, l.height); });
}
void fast(benchmark::State& state) {
    static const LobeMoments moments = make_lobe_moments(weights());
    over_widths(state,
                [](const Lobe& l) { return lobe_to_xyz_fast(weights(), moments, l.peak_nm, l.width_nm, l.height); });
}
// A sum as well as one can be made: weights side by side, cosines by SIMD recurrence.
void good_1nm_sum(benchmark::State& state) {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    settings.adaptation = Adaptation::none;
    const auto sum = make_sum_baseline(make_light(settings), 1);
    over_widths(state, [&](const Lobe& l) { return sum->to_xyz(l); });
}
void exact_per_cell(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return lobe_to_xyz_per_cell(weights(), l.peak_nm, l.width_nm, l.height); });
}
void plain_1nm_sum(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return plain_sum(l, 1); });
}
void plain_5nm_sum(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return plain_sum(l, 5); });
}

// Random sRGB colours: all, those that a lobe has, those that none has.
struct Colours {
    std::vector<Xyz> all, reachable, unreachable;
};

const Light& light() {
    static const Light result = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name("D65");
        return make_light(settings);
    }();
    return result;
}

LobeFinder make_finder() {
    return {light().weights, light().moments, light().adaptation, least_squares_solver()};
}

const LobeFinder& finder() {
    static const LobeFinder result = make_finder();
    return result;
}

Xyz random_srgb(std::mt19937& generator) {
    std::array<double, 3> c{};
    for (double& linear : c) {
        const double value = static_cast<double>(generator()) / 4294967296.0;
        linear = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return {0.4123908 * c[0] + 0.3575843 * c[1] + 0.1804808 * c[2],
            0.2126390 * c[0] + 0.7151687 * c[1] + 0.0721923 * c[2],
            0.0193308 * c[0] + 0.1191948 * c[1] + 0.9505322 * c[2]};
}

const Colours& srgb_colours() {
    static const Colours result = [] {
        std::mt19937 generator(5);
        Colours colours;
        for (int i = 0; i < 10000; ++i) {
            const Xyz colour = random_srgb(generator);
            const bool is_reachable = finder().find(colour).miss == LobeMiss::none;
            colours.all.push_back(colour);
            (is_reachable ? colours.reachable : colours.unreachable).push_back(colour);
        }
        return colours;
    }();
    return result;
}

void find_all(benchmark::State& state, const LobeFinder& by, const std::vector<Xyz>& colours) {
    for (auto _ : state) {
        for (const Xyz& colour : colours) benchmark::DoNotOptimize(by.find(colour));
    }
    state.counters["per_colour"] =
        benchmark::Counter(static_cast<double>(colours.size() * static_cast<std::size_t>(state.iterations())),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void colour_to_lobe_reachable(benchmark::State& state) {
    find_all(state, finder(), srgb_colours().reachable);
}
void colour_to_lobe_unreachable(benchmark::State& state) {
    find_all(state, finder(), srgb_colours().unreachable);
}

// The loop that one would write: the nearest in CIEDE2000 of 118 peaks and 48 widths, each as light as the colour, and
// no search from there.
void colour_to_lobe_of_a_table(benchmark::State& state) {
    std::vector<Xyz> lobes;
    for (int i = 0; i < 118; ++i) {
        for (int j = 1; j < 48; ++j) {
            const double width_nm = 1000.0 * (j / 47.0) * (j / 47.0);
            const Xyz xyz = lobe_to_xyz(light().weights, 360.0 + 4.0 * i, width_nm, 1.0);
            lobes.push_back(adapt(light().adaptation, xyz));
        }
    }
    const std::vector<Xyz>& colours = srgb_colours().unreachable;
    constexpr std::size_t count = 20;
    std::array<double, count> nearest{};
    for (std::size_t i = 0; i < count; ++i) nearest[i] = finder().find(colours[i]).de00;
    double lost = 0.0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) {
            const Lab target = to_lab(colours[i], d65_white);
            double best = 1e9;
            for (const Xyz& lobe : lobes) {
                const double height = std::min(1.0, colours[i].y / std::max(lobe.y, 1e-9));
                const Xyz dimmed{height * lobe.x, height * lobe.y, height * lobe.z};
                best = std::min(best, ciede2000(target, to_lab(dimmed, d65_white)));
            }
            lost = std::max(lost, best - nearest[i]);
        }
    }
    state.counters["lost_dE00"] = lost;  // at worst, beside the search
    state.counters["per_colour"] =
        benchmark::Counter(static_cast<double>(count * static_cast<std::size_t>(state.iterations())),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void lobe_finder_set_up(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(make_finder());
}
BENCHMARK(fast);
BENCHMARK(exact);
BENCHMARK(good_1nm_sum);
BENCHMARK(exact_per_cell);
BENCHMARK(plain_1nm_sum);
BENCHMARK(plain_5nm_sum);
BENCHMARK(colour_to_lobe_reachable);
BENCHMARK(colour_to_lobe_unreachable);
BENCHMARK(colour_to_lobe_of_a_table);
BENCHMARK(lobe_finder_set_up)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre
