#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "reference/layers.h"
#include "reference/light.h"
#include "reference/materials.h"

namespace nacre::reference {
namespace {

double spread_of(const Mechanism& mechanism) {
    if (const auto* film = std::get_if<Film>(&mechanism)) return film->thickness_spread_nm;
    if (const auto* stack = std::get_if<Stack>(&mechanism)) return stack->thickness_spread_nm;
    return std::get<Crystal>(mechanism).thickness_spread_nm;
}

double largest_n(const Index& index) {
    double largest = 0.0;
    for (int nm = light_begins_nm; nm <= light_ends_nm; nm += 10)
        largest = std::max(largest, index_at(index, nm).real());
    return largest;
}

// A normal variable by the trapezium rule, whose error falls as a Gaussian of 2 pi / step less the highest frequency.
std::vector<std::pair<double, double>> normal_steps(double highest_frequency) {
    const double step = 2.0 * std::numbers::pi / (highest_frequency + 6.0);
    std::vector<std::pair<double, double>> steps;
    double whole = 0.0;
    const int side = static_cast<int>(std::ceil(4.6 / step));
    for (int i = -side; i <= side; ++i) {
        steps.emplace_back(i * step, std::exp(-0.5 * square(i * step)));
        whole += steps.back().second;
    }
    for (auto& [at, share] : steps) share /= whole;
    return steps;
}

}  // namespace

std::vector<PlainLayers> thickness_samples_of(const Mechanism& mechanism) {
    const PlainLayers even = layers_of(mechanism);
    const double spread = spread_of(mechanism);
    std::vector<PlainLayers> made{even};
    if (spread == 0.0) return made;
    // Of light that goes there and back so many times.
    const double bounces = std::holds_alternative<Film>(mechanism) ? 6.0 : 2.0;
    const auto frequency = [&](double n, double deviation_nm) {
        return bounces * 4.0 * std::numbers::pi * n * deviation_nm / light_begins_nm;
    };
    if (even.crystal != nullptr) {
        const Crystal& crystal = *even.crystal;
        const double spacing = spacing_of_planes_nm(crystal);
        const double n = std::max(largest_n(crystal.sphere), largest_n(crystal.medium));
        made.clear();
        for (const auto& [z, share] : normal_steps(frequency(n, 0.6 * spread * crystal.planes))) {
            made.push_back(even);
            made.back().share = share;
            made.back().stretch = std::max(1.0 + z * spread / spacing, 0.05);
        }
        return made;
    }
    std::size_t uneven = 0;
    for (std::size_t i = 0; i < even.layers.size(); ++i) {
        if (even.layers[i].is_incoherent) continue;
        if (++uneven > 2) throw std::runtime_error("a spread of more than two layers");
        std::vector<PlainLayers> next;
        const auto steps = normal_steps(frequency(largest_n(even.media[even.layers[i].medium]), spread));
        for (const PlainLayers& sample : made) {
            for (const auto& [z, share] : steps) {
                next.push_back(sample);
                next.back().share *= share;
                double& thickness_nm = next.back().layers[i].thickness_nm;
                thickness_nm = std::max(thickness_nm + z * spread, 0.0);
            }
        }
        made = std::move(next);
    }
    return made;
}

}  // namespace nacre::reference
