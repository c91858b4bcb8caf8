// Colours by an independent method: plain quadrature over wavelength, for everything that is not one mechanism's own
// (reference_mechanisms.cpp has those).
//
// In: a job, whose scene is taken as it is: every effect, no nodes, no grid. Where nothing else is said, the constants
// are empirical; tests/nacre/accuracy/reference_test.cpp compares colours with higher precision.
#include "nacre/accuracy/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "nacre/base/gauss_points.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/lamp_weights.h"
#include "nacre/colour/xyz_sums.h"
#include "nacre/lut/job.h"

namespace nacre {
Reference::Reference(const Job& job, double tolerance_de00)
    : job_(job), tolerance_de00_(tolerance_de00), rule_(unit_gauss_legendre(3)) {
    const LightSettings& light = job.light->settings;
    has_fine_lines_ = has_fine_lines(light.power, light.first_nm, light.last_nm);
    for (int nm = light.first_nm; nm <= light.last_nm; ++nm) {
        const auto& bars = colour_matching(light.observer, nm);
        const double power = has_fine_lines_ ? 1.0 : light.power.at(nm);
        weights_.push_back({power * bars[0], power * bars[1], power * bars[2]});
        kinks_nm_.push_back(nm);
    }
    for (const double nm : light.power.wavelength_nm) {
        if (has_fine_lines_ && nm > light.first_nm && nm < light.last_nm) kinks_nm_.push_back(nm);
    }
    std::sort(kinks_nm_.begin(), kinks_nm_.end());
    Xyz white;
    for (std::size_t i = 1; i < kinks_nm_.size(); ++i) {
        const double length_nm = kinks_nm_[i] - kinks_nm_[i - 1];
        for (const GaussPoint& point : rule_)
            add(white, point.weight * length_nm, weight_at(kinks_nm_[i - 1] + point.at * length_nm));
    }
    for (Xyz& weight : weights_) weight = scaled(weight, 1.0 / white.y);
    adaptation_ = adaptation_matrix(light.adaptation, scaled(white, 1.0 / white.y), d65_white);
}

Xyz Reference::weight_at(double nm) const {
    const double position = nm - job_.light->settings.first_nm;
    const auto cell = std::min(static_cast<std::size_t>(position), weights_.size() - 2);
    const double along = position - static_cast<double>(cell);
    Xyz weight = scaled(weights_[cell], 1.0 - along);
    add(weight, along, weights_[cell + 1]);
    return has_fine_lines_ ? scaled(weight, job_.light->settings.power.at(nm)) : weight;
}

// @pre nm is less than the last one
double Reference::next_kink(double nm) const {
    return has_fine_lines_ ? *std::upper_bound(kinks_nm_.begin(), kinks_nm_.end(), nm) : std::floor(nm) + 1.0;
}

Xyz Reference::band(const Lobe& lobe) const {
    const LightSettings& light = job_.light->settings;
    const double first_nm = light.first_nm;
    const double last_nm = light.last_nm;
    Xyz sum;
    const auto add_piece = [&](double from_nm, double to_nm) {
        from_nm = std::max(from_nm, first_nm);
        to_nm = std::min(to_nm, last_nm);
        // The cosine of a narrow band bends within a nanometre.
        const double longest_nm = std::min(1.0, 0.125 * (to_nm - from_nm));
        for (double left = from_nm; left < to_nm;) {
            const double right = std::min({next_kink(left), to_nm, left + longest_nm});
            if (!(right > left)) break;  // the rest is narrower than a double resolves
            for (const GaussPoint& point : rule_) {
                const double nm = left + point.at * (right - left);
                add(sum, point.weight * (right - left) * lobe_reflectance(lobe, nm), weight_at(nm));
            }
            left = right;
        }
    };
    // Piece by piece, because the slope jumps where a shoulder begins and ends.
    const double half_nm = 0.5 * lobe.width_nm;
    const double half_plateau_nm = lobe.flatness * half_nm;
    if (lobe.floor != 0.0) add_piece(first_nm, lobe.peak_nm - half_nm);
    if (lobe.flatness == 0.0) {
        add_piece(lobe.peak_nm - half_nm, lobe.peak_nm + half_nm);
    } else {
        add_piece(lobe.peak_nm - half_nm, lobe.peak_nm - half_plateau_nm);
        add_piece(lobe.peak_nm - half_plateau_nm, lobe.peak_nm + half_plateau_nm);
        add_piece(lobe.peak_nm + half_plateau_nm, lobe.peak_nm + half_nm);
    }
    if (lobe.floor != 0.0) add_piece(lobe.peak_nm + half_nm, last_nm);
    return sum;
}

// A spectrum is a parabola over every two steps, and is integrated piece by piece where the weights are straight: where
// they are straight over both steps, by Simpson's rule, which is exact for a cubic.
const Reference::Samples& Reference::samples(int cells) const {
    Samples& made = samples_[cells];
    if (!made.nm.empty()) return made;
    const LightSettings& light = job_.light->settings;
    for (int i = 0; i <= cells; ++i)
        made.nm.push_back(std::lerp(light.first_nm, light.last_nm, static_cast<double>(i) / cells));
    for (std::size_t i = 1; i < made.nm.size(); i += 2) made.added.push_back(made.nm[i]);
    made.weights.resize(made.nm.size());
    Xyz weight_at_end = weight_at(made.nm.front());
    for (std::size_t i = 2; i < made.nm.size(); i += 2) {
        const double from = made.nm[i - 2];
        const double to = made.nm[i];
        const Xyz weight_at_begin = std::exchange(weight_at_end, weight_at(to));
        if (next_kink(from) >= to) {
            const double sixth_nm = (to - from) / 6.0;
            add(made.weights[i - 2], sixth_nm, weight_at_begin);
            add(made.weights[i - 1], 4.0 * sixth_nm, weight_at(made.nm[i - 1]));
            add(made.weights[i], sixth_nm, weight_at_end);
            continue;
        }
        for (double left = from, right = from; left < to; left = right) {
            right = std::min(next_kink(left), to);
            for (const GaussPoint& point : rule_) {
                const double nm = std::lerp(left, right, point.at);
                const double t = 2.0 * (nm - from) / (to - from) - 1.0;
                const Xyz weight = scaled(weight_at(nm), point.weight * (right - left));
                add(made.weights[i - 2], 0.5 * t * (t - 1.0), weight);
                add(made.weights[i - 1], (1.0 - t) * (1.0 + t), weight);
                add(made.weights[i], 0.5 * t * (t + 1.0), weight);
            }
        }
    }
    return made;
}

// Twice, for of a rule of second order, as most here become where something bends, half as many points err by four
// times as much as all, and what they change is three times that. Not a number is no doubt: more points would not help.
double Reference::doubt(const Xyz& of_all, const Xyz& of_half) const {
    const Xyz seen = adapt(adaptation_, of_all);
    return difference_at(seen, adapt(adaptation_, of_half), display_scale(seen.y)) / (2.0 * tolerance_de00_);
}

namespace {

// Every second value is of one, beginning and ending with the first.
std::vector<double> merged(const std::vector<double>& known, const std::vector<double>& added) {
    std::vector<double> all(known.size() + added.size());
    for (std::size_t i = 0; i < known.size(); ++i) all[2 * i] = known[i];
    for (std::size_t i = 0; i < added.size(); ++i) all[2 * i + 1] = added[i];
    return all;
}

}  // namespace

// Part by part, so that what was prepared for fewer cells serves for more.
std::vector<double> Reference::values_at(int cells, int fewest, const Spectrum& spectrum) const {
    if (cells == fewest) return spectrum(samples(cells).nm);
    return merged(values_at(cells / 2, fewest, spectrum), spectrum(samples(cells).added));
}

// Lines that are narrower than the steps may agree by chance, but not twice.
Xyz Reference::integral(double longest_step_nm, int& begin, const Spectrum& spectrum, int most_cells,
                        std::vector<double>* taken) const {
    constexpr double of_second_order = 4.0;
    constexpr double of_fourth_order = 16.0;
    const LightSettings& light = job_.light->settings;
    const int fewest = 8 * static_cast<int>(std::ceil(0.125 * (light.last_nm - light.first_nm) / longest_step_nm));
    int cells = fewest;
    while (cells < std::min(begin, most_cells)) cells *= 2;
    std::vector<double> values = values_at(cells, fewest, spectrum);
    for (;; cells *= 2, values = merged(values, spectrum(samples(cells).added))) {
        std::array<Xyz, 3> sums;  // of all, of every second and of every fourth
        for (std::size_t part = 0, step = 1; part < sums.size(); ++part, step *= 2) {
            const std::vector<Xyz>& weights = samples(cells / static_cast<int>(step)).weights;
            for (std::size_t i = 0; i < weights.size(); ++i) add(sums[part], values[step * i], weights[i]);
        }
        const double left = std::max(doubt(sums[0], sums[1]), doubt(sums[1], sums[2]) / of_second_order);
        if (cells < most_cells && left > 1.0) continue;
        begin = cells > fewest && of_fourth_order * left < 1.0 ? cells / 2 : cells;
        if (taken != nullptr) *taken = std::move(values);
        return sums[0];
    }
}

Xyz Reference::at(double x, double y) const {
    const Mechanism mechanism = mechanism_at(job_, x, y);
    const Geometry geometry = geometry_at(job_, x, y);
    const Xyz seen =
        mechanism.effects.relief.is_plane() ? flat(mechanism, geometry) : mean_of_facets(mechanism, geometry.incidence);
    return adapt(adaptation_, seen);
}

}  // namespace nacre
