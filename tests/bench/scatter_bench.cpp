// Spheres: what their series take beside the textbook's, and a LUT of scattering beside a sum over every nanometre.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "bench/lut_colours.h"
#include "nacre/cost/baselines.h"
#include "nacre/optics/mie.h"
#include "nacre/shade/scatter_colour.h"

namespace nacre::bench {
namespace {

// The baseline, as everybody has it: Riccati-Bessel functions by recurrence upwards, logarithmic derivatives downwards,
// x + 4 cbrt(x) + 2 terms (Bohren & Huffman 1983, section 4.8). It begins downwards at 15 beyond |m x|, which is too
// few for large spheres. @returns the efficiency of scattering
double textbook_q_sca(double x, std::complex<double> m) {
    const std::complex<double> mx = m * x;
    const int terms = static_cast<int>(x + 4.0 * std::cbrt(x) + 2.0);
    const int first = std::max(terms, static_cast<int>(std::abs(mx))) + 15;
    std::vector<std::complex<double>> derivative(static_cast<std::size_t>(first) + 1);
    for (int n = first; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        const std::complex<double> ratio = static_cast<double>(n) / mx;
        derivative[i - 1] = ratio - 1.0 / (derivative[i] + ratio);
    }
    std::complex<double> before(std::cos(x), std::sin(x));  // psi - i chi, of order -1
    std::complex<double> last(std::sin(x), -std::cos(x));
    double sum = 0.0;
    for (int n = 1; n <= terms; ++n) {
        const std::complex<double> wave = (2.0 * n - 1.0) / x * last - before;
        before = last;
        last = wave;
        const std::complex<double> d = derivative[static_cast<std::size_t>(n)];
        const std::complex<double> electric = d / m + n / x;
        const std::complex<double> magnetic = d * m + n / x;
        const auto a = (electric * last.real() - before.real()) / (electric * last - before);
        const auto b = (magnetic * last.real() - before.real()) / (magnetic * last - before);
        sum += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
    }
    return 2.0 / (x * x) * sum;
}

// Ours also has coefficients, absorption and asymmetry, to 1e-12 (tests/nacre/optics/mie_test.cpp), which is what the
// baseline's q_sca is held against.
void sphere(benchmark::State& state, double x) {
    const std::complex<double> m(1.59, 1e-3);
    constexpr int times = 64;
    double ours = 0.0, theirs = 0.0;
    for (auto _ : state) {
        ours += seconds_of([&] {
            for (int i = 0; i < times; ++i) benchmark::DoNotOptimize(mie_sphere(x * (1.0 + 1e-3 * i), m));
        });
        theirs += seconds_of([&] {
            for (int i = 0; i < times; ++i) benchmark::DoNotOptimize(textbook_q_sca(x * (1.0 + 1e-3 * i), m));
        });
    }
    double error = 0.0;
    for (int i = 0; i < times; ++i) {
        const double q_sca = mie_sphere(x * (1.0 + 1e-3 * i), m).q_sca;
        error = std::max(error, std::abs(textbook_q_sca(x * (1.0 + 1e-3 * i), m) / q_sca - 1.0));
    }
    state.counters["us"] = 1e6 * ours / (times * static_cast<double>(state.iterations()));
    state.counters["ratio"] = theirs / ours;
    state.counters["baseline_digits"] = -std::log10(std::max(error, 1e-17));
}

// ---- A LUT: spheres once, and then angles ----

void scattering(benchmark::State& state, double radius_spread) {
    Scatter milk;
    milk.model = ScatterModel::mie;
    milk.particle = 1.46;
    milk.medium = 1.33;
    milk.radius_nm = 300.0;
    milk.radius_spread = radius_spread;
    const Job job = decided(milk);
    Job every_nm = job;
    every_nm.sampling.nodes.fill(std::make_shared<const SpectralNodes>(sum_nodes(*job.light, 1)));
    double ours = 0.0, set_up = 0.0, theirs = 0.0;
    for (auto _ : state) {
        set_up += seconds_of(
            [&] { benchmark::DoNotOptimize(ScatterColour(job.material.mechanism, job.sampling).samples()); });
        ours += seconds_of([&] { benchmark::DoNotOptimize(bake(job)); });
        theirs += seconds_of([&] { benchmark::DoNotOptimize(bake(every_nm)); });
    }
    state.counters["us"] = 1e6 * ours / static_cast<double>(state.iterations());
    state.counters["set_up"] = set_up / ours;  // the part that spheres take
    state.counters["nodes"] = job.sampling.counts().nodes.front();
    state.counters["sizes"] = job.sampling.radii;
    state.counters["ratio_1nm"] = theirs / ours;
    state.counters["difference_dE00"] = largest_difference(colours_of(bake(job)), colours_of(bake(every_nm)));
}

BENCHMARK_CAPTURE(sphere, x_1e_3, 1e-3);
BENCHMARK_CAPTURE(sphere, x_1, 1.0);
BENCHMARK_CAPTURE(sphere, x_30, 30.0);
BENCHMARK_CAPTURE(sphere, x_1000, 1e3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scattering, of_one_size, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scattering, of_many_sizes, 0.2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre::bench
