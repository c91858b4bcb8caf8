// One lobe to XYZ, widths 40 to 400 nm: the exact integral and the fast one beside the sums that others make, and
// beside their simple twin.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "nacre/accuracy/rivals.h"
#include "nacre/bake/light.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/optics/lobe.h"

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
    const auto sum = make_sum_rival(make_light(settings), 1);
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

BENCHMARK(fast);
BENCHMARK(exact);
BENCHMARK(good_1nm_sum);
BENCHMARK(exact_per_cell);
BENCHMARK(plain_1nm_sum);
BENCHMARK(plain_5nm_sum);

}  // namespace
}  // namespace nacre
