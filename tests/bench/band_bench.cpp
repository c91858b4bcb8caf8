// One band to XYZ, widths 40 to 400 nm: the exact integral beside the sums that others make, and beside its scalar
// reference implementation. And back: a colour to its band, beside a look-up in a table; two colours to their bands.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/cost/baselines.h"
#include "nacre/optics/lobe.h"
#include "nacre/pick/band/exact_bands.h"
#include "nacre/pick/band/palette_bands.h"
#include "nacre/pick/band/shown_colour.h"
#include "nacre/shade/palette_colour.h"

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
            const Xyz reference = band_to_xyz_per_cell(weights(), {peak_nm, width_nm});
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

Xyz scaled(const Xyz& colour, double factor) {
    return {colour.x * factor, colour.y * factor, colour.z * factor};
}

void exact(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return scaled(band_to_xyz(weights(), {l.peak_nm, l.width_nm}), l.height); });
}
void exact_half_flat(benchmark::State& state) {
    double sum = 0.0;
    for (auto _ : state) {
        for (double width_nm = 40.0; width_nm <= 400.0; width_nm += 3.7)
            sum += band_to_xyz(weights(), {450.3 + 0.5 * width_nm, width_nm, 0.5}).y;
    }
    benchmark::DoNotOptimize(sum);
    state.counters["per_lobe"] = benchmark::Counter(98.0 * static_cast<double>(state.iterations()),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
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
    over_widths(state, [](const Lobe& l) {
        return scaled(band_to_xyz_per_cell(weights(), {l.peak_nm, l.width_nm}), l.height);
    });
}
void plain_1nm_sum(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return plain_sum(l, 1); });
}
void plain_5nm_sum(benchmark::State& state) {
    over_widths(state, [](const Lobe& l) { return plain_sum(l, 5); });
}

const Light& light() {
    static const Light result = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name("D65");
        return make_light(settings);
    }();
    return result;
}

const ExactBands& bands() {
    static const ExactBands result(light());
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

constexpr std::size_t colour_count = 10000;

// Random sRGB colours, and the same so bright that no reflectance has them.
std::vector<Xyz> srgb_colours(double brightness) {
    std::mt19937 generator(5);
    std::vector<Xyz> colours;
    for (std::size_t i = 0; i < colour_count; ++i) colours.push_back(scaled(random_srgb(generator), brightness));
    return colours;
}

void count_per_colour(benchmark::State& state, std::size_t colours) {
    state.counters["per_colour"] =
        benchmark::Counter(static_cast<double>(colours * static_cast<std::size_t>(state.iterations())),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void find_all(benchmark::State& state, double brightness) {
    const std::vector<Xyz> colours = srgb_colours(brightness);
    for (auto _ : state) {
        for (const Xyz& colour : colours) {
            const ShownColour shown = shown_colour(bands(), light(), colour);
            benchmark::DoNotOptimize(palette_bands(bands(), light(), {{0.0, shown.colour, {}}}));
        }
    }
    count_per_colour(state, colours.size());
}

void colour_to_band(benchmark::State& state) {
    find_all(state, 1.0);
}
void colour_to_band_dimmed(benchmark::State& state) {
    find_all(state, 20.0);
}

// Two picks, whose bands are chosen together.
void pair_to_bands(benchmark::State& state) {
    const std::vector<Xyz> colours = srgb_colours(1.0);
    constexpr std::size_t pairs = 200;
    for (auto _ : state) {
        for (std::size_t i = 0; i < pairs; ++i) {
            benchmark::DoNotOptimize(
                palette_bands(bands(), light(), {{0.0, colours[2 * i], {}}, {60.0, colours[2 * i + 1], {}}}));
        }
    }
    count_per_colour(state, 2 * pairs);
}

// The loop that one would write: the nearest in CIEDE2000 of 118 peaks and 48 widths, each as light as the colour, and
// no search from there.
void colour_to_band_of_a_table(benchmark::State& state) {
    std::vector<Xyz> table;
    for (int i = 0; i < 118; ++i) {
        for (int j = 1; j < 48; ++j) {
            const double width_nm = 1000.0 * (j / 47.0) * (j / 47.0);
            table.push_back(adapt(light().adaptation, lobe_to_xyz(light(), {360.0 + 4.0 * i, width_nm, 1.0})));
        }
    }
    const std::vector<Xyz> colours = srgb_colours(1.0);
    constexpr std::size_t count = 20;
    double missed = 0.0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) {
            const Lab target = to_lab(colours[i], d65_white);
            double best = 1e9;
            for (const Xyz& band : table) {
                const double height = std::min(1.0, colours[i].y / std::max(band.y, 1e-9));
                best = std::min(best, ciede2000(target, to_lab(scaled(band, height), d65_white)));
            }
            missed = std::max(missed, best);
        }
    }
    state.counters["worst_dE00"] = missed;
    count_per_colour(state, count);
}

void band_tables_set_up(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(ExactBands(light()));
}
BENCHMARK(exact);
BENCHMARK(exact_half_flat);
BENCHMARK(good_1nm_sum);
BENCHMARK(exact_per_cell);
BENCHMARK(plain_1nm_sum);
BENCHMARK(plain_5nm_sum);
BENCHMARK(colour_to_band);
BENCHMARK(colour_to_band_dimmed);
BENCHMARK(pair_to_bands);
BENCHMARK(colour_to_band_of_a_table);
BENCHMARK(band_tables_set_up)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre
