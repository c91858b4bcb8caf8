// Films and stacks: 256 angles x 401 wavelengths of unpolarised light on one thread, beside the scalar characteristic
// matrices that one would write; a LUT; and a stack of ten thousand layers. Read the ratios.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <ctime>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "bench/whole.h"
#include "io/ocio/colour_config.h"
#include "nacre/colour/illuminant.h"
#include "nacre/cost/baselines.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/shade/layered_colour.h"
#include "pipeline/baked_lut.h"

namespace nacre {
namespace {

constexpr int angles = 256;
constexpr int wavelengths = 401;  // 380 to 780 nm

Incidence incidence_of(int i) {
    return Incidence::from_sqrt_cos(static_cast<double>(i) / (angles - 1));
}

std::vector<double> wavelengths_nm() {
    std::vector<double> nm;
    for (int i = 0; i < wavelengths; ++i) nm.push_back(380.0 + i);
    return nm;
}

// Thicknesses all over the place, as tolerances make them: nothing to be had from equal layers.
double thickness_nm(int layer) {
    const double step = 0.61803398874989485 * layer;
    return 60.0 + 80.0 * (step - std::floor(step));
}

LayerSystem stack(int layers, const RefractiveIndex& high) {
    LayerSystemBuilder builder(Index(1.0), Index(1.52));
    for (int i = 0; i < layers; ++i) builder.layer(i % 2 == 0 ? Index(high) : Index(1.46), thickness_nm(i));
    return builder.take();
}
LayerSystem lossless(int layers) {
    return stack(layers, 2.3);
}
LayerSystem absorbing(int layers) {
    return stack(layers, {2.3, 0.02});
}
LayerSystem ten_periods() {
    LayerSystemBuilder builder(Index(1.0), Index(1.52));
    builder.begin_group(10);
    builder.layer(Index(2.3), 60.0);
    builder.layer(Index(1.46), 95.0);
    builder.end_group();
    return builder.take();
}
LayerSystem film() {
    LayerSystemBuilder builder(Index(1.0), Index(1.52));
    builder.layer(Index(1.33), 420.0);
    return builder.take();
}

// ---- The baseline: characteristic matrices in std::complex, one wavelength and angle after the other ----

// As a good programmer writes it who does not reach for SIMD: repeats multiplied out once, indices looked up once per
// wavelength, squares of indices kept, s and p share roots, sines and cosines; products are written out, for those of
// std::complex ask for infinities (-ffast-math is not for everybody). No allocation inside.
class ScalarMatrices {
public:
    using Complex = std::complex<double>;

    ScalarMatrices(const LayerSystem& system, const std::vector<double>& nm) : nm_(nm), media_(system.media.size()) {
        for (std::size_t i = 0; i < system.nodes.size();) i = expand(system, i);
        incident_ = static_cast<std::size_t>(system.incident);
        substrate_ = static_cast<std::size_t>(system.substrate);
        for (const double wavelength : nm)
            for (std::size_t m = 0; m < media_; ++m) index_.push_back(system.index_at(static_cast<int>(m), wavelength));
        for (const Complex& n : index_) square_.push_back(times(n, n));
        q_.resize(media_);
    }

    /// Unpolarised.
    void reflectances(const Incidence& incidence, double* out) {
        // The last bit short of grazing, where p has no admittance.
        const double cosine = std::max(incidence.cos_theta, 1e-9);
        for (std::size_t i = 0; i < nm_.size(); ++i) out[i] = reflectance(cosine, i);
    }

private:
    struct Layer {
        std::size_t medium = 0;
        double thickness_nm = 0.0;
    };
    struct Column {
        Complex e, h;
    };

    static Complex times(const Complex& a, const Complex& b) {
        return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
    }
    static Complex over(const Complex& a, const Complex& b) { return times(a, std::conj(b)) / norm(b); }
    static double norm(const Complex& a) { return a.real() * a.real() + a.imag() * a.imag(); }

    std::size_t expand(const LayerSystem& system, std::size_t i) {
        const LayerNode& node = system.nodes[i];
        if (node.repeat == 0) {
            layers_.push_back({static_cast<std::size_t>(node.medium), node.thickness_nm});
            return i + 1;
        }
        const std::size_t end = i + 1 + static_cast<std::size_t>(node.count);
        for (int time = 0; time < node.repeat; ++time)
            for (std::size_t k = i + 1; k < end;) k = expand(system, k);
        return end;
    }

    // Born & Wolf, 7th ed., 1.6: the column (E, H) is multiplied from the substrate up; two products of 2 x 2 by 2.
    double reflectance(double cosine, std::size_t i) {
        const Complex* squares = &square_[i * media_];
        const double n0 = index_[i * media_ + incident_].real();
        const double transverse = n0 * n0 * (1.0 - cosine) * (1.0 + cosine);
        for (std::size_t m = 0; m < media_; ++m) q_[m] = std::sqrt(squares[m] - transverse);
        Column s{1.0, q_[substrate_]};
        Column p{1.0, over(squares[substrate_], q_[substrate_])};
        const double wave_number = 2.0 * std::numbers::pi / nm_[i];
        for (std::size_t k = layers_.size(); k-- > 0;) {
            const Layer& layer = layers_[k];
            const Complex& q = q_[layer.medium];
            const Complex phase = wave_number * layer.thickness_nm * q;
            Complex sine, cos_phase;
            if (phase.imag() == 0.0) {
                sine = std::sin(phase.real());
                cos_phase = std::cos(phase.real());
            } else {
                const double grown = std::exp(phase.imag()), shrunk = 1.0 / grown;
                const double a = std::sin(phase.real()), b = std::cos(phase.real());
                sine = {0.5 * a * (grown + shrunk), 0.5 * b * (grown - shrunk)};
                cos_phase = {0.5 * b * (grown + shrunk), -0.5 * a * (grown - shrunk)};
            }
            const Complex admittance_p = over(squares[layer.medium], q);
            step(s, cos_phase, sine, q);
            step(p, cos_phase, sine, admittance_p);
        }
        return 0.5 * (reflected(s, n0 * cosine) + reflected(p, n0 / cosine));
    }
    static void step(Column& column, const Complex& cosine, const Complex& sine, const Complex& admittance) {
        const Complex i_sine(sine.imag(), -sine.real());  // -i sin: exp(-i omega t)
        const Complex e = times(cosine, column.e) + over(times(i_sine, column.h), admittance);
        column.h = times(times(i_sine, admittance), column.e) + times(cosine, column.h);
        column.e = e;
    }
    static double reflected(const Column& column, double admittance) {
        return norm(admittance * column.e - column.h) / norm(admittance * column.e + column.h);
    }

    const std::vector<double>& nm_;
    std::size_t media_ = 0, incident_ = 0, substrate_ = 0;
    std::vector<Layer> layers_;
    std::vector<Complex> index_, square_;  // media_ per wavelength
    std::vector<Complex> q_;
};

// Of this processor: a shared machine's wall clock counts its other tenants too.
double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// The largest difference between the two: what makes the baseline a baseline.
double largest_difference(const LayerSystem& system, const std::vector<double>& nm) {
    const MultilayerSolver solver(system, nm);
    ScalarMatrices baseline(system, nm);
    std::vector<Response> ours(nm.size());
    std::vector<double> theirs(nm.size());
    double largest = 0.0;
    for (int i = 1; i < angles; ++i) {
        solver.responses(incidence_of(i), ours);
        baseline.reflectances(incidence_of(i), theirs.data());
        for (std::size_t k = 0; k < nm.size(); ++k)
            largest = std::max(largest, std::abs(ours[k].reflectance() - theirs[k]));
    }
    return largest;
}

// ---- 256 angles x 401 wavelengths ----

// Both in turn inside of one loop, so that whatever else the machine does slows both.
void spectra(benchmark::State& state, const LayerSystem& system) {
    const std::vector<double> nm = wavelengths_nm();
    ScalarMatrices baseline(system, nm);
    std::vector<Response> responses(nm.size());
    std::vector<double> reflectances(nm.size());
    double ours = 0.0, summed = 0.0, theirs = 0.0;
    for (auto _ : state) {
        // Preparing is part of it: a bake does it once for all angles.
        std::optional<MultilayerSolver> solver;
        ours += seconds_of([&] {
            solver.emplace(system, nm);
            for (int i = 0; i < angles; ++i) {
                solver->responses(incidence_of(i), responses);
                benchmark::DoNotOptimize(responses.data());
            }
        });
        const std::vector<double> weights(solver->padded_count(), 1.0 / wavelengths);
        summed += seconds_of([&] {
            for (int i = 0; i < angles; ++i) {
                benchmark::DoNotOptimize(
                    solver->weighted_reflectances(incidence_of(i), {weights.data(), weights.data(), weights.data()}));
            }
        });
        theirs += seconds_of([&] {
            for (int i = 0; i < angles; ++i) {
                baseline.reflectances(incidence_of(i), reflectances.data());
                benchmark::DoNotOptimize(reflectances.data());
            }
        });
    }
    const double samples = static_cast<double>(state.iterations()) * angles * wavelengths;
    state.counters["ns_per_sample"] = 1e9 * ours / samples;             // R and T of s and p
    state.counters["ns_per_weighted_sample"] = 1e9 * summed / samples;  // R only, summed at once: what a bake does
    state.counters["baseline_ns_per_sample"] = 1e9 * theirs / samples;
    state.counters["ratio"] = theirs / ours;
    state.counters["weighted_ratio"] = theirs / summed;
    state.counters["difference"] = largest_difference(system, nm);
}
void spectra_20_lossless(benchmark::State& state) {
    spectra(state, lossless(20));
}
void spectra_20_absorbing(benchmark::State& state) {
    spectra(state, absorbing(20));
}
void spectra_10_periods(benchmark::State& state) {
    spectra(state, ten_periods());
}
void spectra_1_film(benchmark::State& state) {
    spectra(state, film());
}

// ---- A LUT ----

PlannedLut planned_lut() {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    Stack mechanism{Index(1.0), {}, Index(1.52)};
    for (int i = 0; i < 20; ++i) {
        Layer layer;
        layer.index = i % 2 == 0 ? Index(2.3) : Index(1.46);
        layer.thickness_nm = thickness_nm(i);
        mechanism.layers.push_back(layer);
    }
    PlannedLut lut;
    lut.name = "stack";
    lut.job.material = {"stack", mechanism, {}};
    lut.job.light = std::make_shared<const Light>(make_light(settings));
    lut.job.width = 256;
    lut.request.width = 256;
    lut.request.max_de00 = 0.02;
    return lut;
}

ColourTransform to_rec709() {
    return ColourConfig::open({"", "", "bench"}).to_colour_space("lin_rec709", "bench");
}

// Texels of the chosen job; a sum over every nanometre with the same solver; and with the baseline's.
void lut_256_of_20_layers(benchmark::State& state) {
    const ColourTransform transform = to_rec709();
    const ChosenLut chosen = choose_lut(planned_lut(), lut_encoding(transform, Gamut::keep));
    const Job& job = chosen.lut.job;
    const SpectralNodes sum = sum_nodes(*job.light, 1);
    SpectralSampling every_nm = job.sampling;
    every_nm.nodes.fill(std::make_shared<const SpectralNodes>(sum));
    const LayerSystem system = even_system(job.material.mechanism);
    double ours = 0.0, same_solver = 0.0, theirs = 0.0;
    for (auto _ : state) {
        ours += seconds_of([&] { benchmark::DoNotOptimize(bake(job)); });
        same_solver += seconds_of([&] {
            Job sampled = job;
            sampled.sampling = every_nm;
            benchmark::DoNotOptimize(bake(sampled));
        });
        theirs += seconds_of([&] {
            ScalarMatrices baseline(system, sum.wavelength_nm);
            std::vector<double> reflectances(sum.wavelength_nm.size());
            for (int i = 0; i < angles; ++i) {
                baseline.reflectances(incidence_of(i), reflectances.data());
                Xyz seen;
                for (std::size_t k = 0; k < reflectances.size(); ++k) {
                    seen.x += reflectances[k] * sum.x[k];
                    seen.y += reflectances[k] * sum.y[k];
                    seen.z += reflectances[k] * sum.z[k];
                }
                benchmark::DoNotOptimize(adapt(job.light->adaptation, seen));
            }
        });
    }
    const double luts = static_cast<double>(state.iterations());
    state.counters["ms"] = 1e3 * ours / luts;
    state.counters["ms_1nm_same_solver"] = 1e3 * same_solver / luts;
    state.counters["ms_1nm_scalar"] = 1e3 * theirs / luts;
    state.counters["ratio_to_1nm"] = same_solver / ours;
    state.counters["ratio_to_scalar"] = theirs / ours;
    state.counters["nodes"] = job.sampling.counts().nodes.front();
    state.counters["spectrum_dE00"] = chosen.predicted.spectrum;
    state.counters["texels"] = job.width;
}

// Deciding on that LUT's size, format and nodes.
void decide_20_layers_for_0_02(benchmark::State& state) {
    PlannedLut lut = planned_lut();
    lut.request.width.reset();
    const ColourTransform transform = to_rec709();
    const Encoding encoding = lut_encoding(transform, Gamut::keep);
    for (auto _ : state) benchmark::DoNotOptimize(choose_lut(lut, encoding));
}

// That and all that a bake does besides, beside computing alone.
void whole_20_layers_for_0_02(benchmark::State& state) {
    PlannedLut lut = planned_lut();
    lut.request.width.reset();
    const ColourTransform transform = to_rec709();
    const Encoding encoding = lut_encoding(transform, Gamut::keep);
    for (auto _ : state) bench::report(state, bench::median_whole_bake(lut, encoding));
}

// ---- Ten thousand layers ----

// At every fifth nanometre, which is what time allows the baseline: 256 angles of ours; four of the baseline's,
// times 64.
void ten_thousand(benchmark::State& state, const LayerSystem& system) {
    std::vector<double> nm;
    for (int i = 0; i <= 80; ++i) nm.push_back(380.0 + 5.0 * i);
    constexpr int every = 64;
    double ours = 0.0, theirs = 0.0;
    std::vector<Response> responses(nm.size());
    std::vector<double> reflectances(nm.size());
    for (auto _ : state) {
        ours += seconds_of([&] {
            const MultilayerSolver solver(system, nm);
            for (int i = 0; i < angles; ++i) {
                solver.responses(incidence_of(i), responses);
                benchmark::DoNotOptimize(responses.data());
            }
        });
        theirs += every * seconds_of([&] {
                      ScalarMatrices baseline(system, nm);
                      for (int i = every - 1; i < angles; i += every) {
                          baseline.reflectances(incidence_of(i), reflectances.data());
                          benchmark::DoNotOptimize(reflectances.data());
                      }
                  });
    }
    const double runs = static_cast<double>(state.iterations());
    state.counters["s_256_angles"] = ours / runs;
    state.counters["ns_per_layer"] = 1e9 * ours / runs / (10000.0 * angles * static_cast<double>(nm.size()));
    state.counters["ratio"] = theirs / ours;
}
void ten_thousand_lossless(benchmark::State& state) {
    ten_thousand(state, lossless(10000));
}
void ten_thousand_absorbing(benchmark::State& state) {
    ten_thousand(state, absorbing(10000));
}

// No two alike, and 401 wavelengths: what takes most memory. layer_memory.sh runs it alone.
void ten_thousand_different(benchmark::State& state) {
    LayerSystemBuilder builder(Index(1.0), Index(1.52));
    for (int i = 0; i < 10000; ++i) {
        const double n = i % 2 == 0 ? 1.46 : 2.3 + 1e-5 * i;
        builder.layer(Index(RefractiveIndex(n, i % 2 == 0 ? 0.0 : 1e-4)), thickness_nm(i));
    }
    const LayerSystem system = builder.take();
    const std::vector<double> nm = wavelengths_nm();
    std::vector<Response> responses(nm.size());
    for (auto _ : state) {
        const MultilayerSolver solver(system, nm);
        for (int i = 0; i < angles; ++i) {
            solver.responses(incidence_of(i), responses);
            benchmark::DoNotOptimize(responses.data());
        }
    }
    state.counters["media"] = static_cast<double>(system.media.size());
}

BENCHMARK(spectra_20_lossless)->Unit(benchmark::kMillisecond);
BENCHMARK(spectra_20_absorbing)->Unit(benchmark::kMillisecond);
BENCHMARK(spectra_10_periods)->Unit(benchmark::kMillisecond);
BENCHMARK(spectra_1_film)->Unit(benchmark::kMillisecond);
BENCHMARK(lut_256_of_20_layers)->Unit(benchmark::kMillisecond);
BENCHMARK(decide_20_layers_for_0_02)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_20_layers_for_0_02)->Unit(benchmark::kMillisecond);
BENCHMARK(ten_thousand_lossless)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ten_thousand_absorbing)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(ten_thousand_different)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace nacre
