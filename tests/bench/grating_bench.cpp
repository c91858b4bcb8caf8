// Gratings: a LUT, beside sums over every nanometre and every tenth of one. Read the ratios, and what they buy.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bench/lut_colours.h"

namespace nacre::bench {
namespace {

// The baseline: a sum over wavelength with the same orders, whose efficiencies are kept; one sine for all orders.
class GratingSum {
public:
    GratingSum(const Grating& grating, const Light& light, int per_nm) : grating_(grating) {
        const TristimulusWeights& weights = light.weights;
        orders_ = counted_orders(grating, weights.first_nm);
        for (int i = 0; i <= (weights.count() - 1) * per_nm; ++i) {
            const auto cell = static_cast<std::size_t>(std::min(i / per_nm, weights.count() - 2));
            const double along = static_cast<double>(i) / per_nm - static_cast<double>(cell);
            const auto weight = [&](const std::vector<double>& w) { return std::lerp(w[cell], w[cell + 1], along); };
            nm_.push_back(weights.first_nm + static_cast<double>(i) / per_nm);
            weight_.push_back({weight(weights.x) / per_nm, weight(weights.y) / per_nm, weight(weights.z) / per_nm});
            for (const int order : orders_) efficiency_.push_back(grating_efficiency(grating, order, nm_.back()));
        }
    }
    Xyz at(double u) const {
        const double grooves = grating_.grooves;
        Xyz sum;
        for (std::size_t i = 0; i < nm_.size(); ++i) {
            const double x = u * grating_.period_nm / nm_[i];
            const double sine = std::sin(std::numbers::pi * grooves * x);
            double seen = 0.0;
            for (std::size_t k = 0; k < orders_.size(); ++k) {
                const double efficiency = efficiency_[i * orders_.size() + k];
                for (const double order : {1.0 * orders_[k], -1.0 * orders_[k]}) {
                    const double t = std::numbers::pi * grooves * (x - order);
                    seen += efficiency * (std::abs(t) < 1e-7 ? 1.0 : sine * sine / (t * t));
                }
            }
            seen *= grooves * grating_.period_nm / nm_[i];
            sum = {sum.x + seen * weight_[i].x, sum.y + seen * weight_[i].y, sum.z + seen * weight_[i].z};
        }
        return sum;
    }

private:
    Grating grating_;
    std::vector<int> orders_;
    std::vector<double> nm_;
    Colours weight_;
    std::vector<double> efficiency_;  // per wavelength, order
};

// Grooves that light meets in phase: some tens to hundreds for sunlight, thousands for a laser's width.
void grating(benchmark::State& state) {
    Grating disc;
    disc.depth_nm = 120.0;
    disc.grooves = static_cast<int>(state.range(0));
    const Job job = decided(disc);
    const GratingSum coarse(disc, *job.light, 1);
    const GratingSum fine(disc, *job.light, 10);
    const auto summed = [&](const GratingSum& sum) {
        Colours colours;
        for (int i = 0; i < texels; ++i)
            colours.push_back(adapt(job.light->adaptation, sum.at(geometry_of_texel(job, i).grating_u)));
        return colours;
    };
    double ours = 0.0, at_1_nm = 0.0, at_tenths = 0.0;
    for (auto _ : state) {
        ours += seconds_of([&] { benchmark::DoNotOptimize(bake(job)); });
        at_1_nm += seconds_of([&] { benchmark::DoNotOptimize(summed(coarse)); });
        at_tenths += seconds_of([&] { benchmark::DoNotOptimize(summed(fine)); });
    }
    const Colours colours = colours_of(bake(job));  // to 2e-7 (grating_colour_test): the truth here
    state.counters["us"] = 1e6 * ours / static_cast<double>(state.iterations());
    state.counters["ratio_1nm"] = at_1_nm / ours;
    state.counters["ratio_0.1nm"] = at_tenths / ours;
    state.counters["dE00_1nm"] = largest_difference(summed(coarse), colours);
    state.counters["dE00_0.1nm"] = largest_difference(summed(fine), colours);
}

BENCHMARK(grating)->Arg(100)->Arg(3000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre::bench
