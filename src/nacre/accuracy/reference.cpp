#include "nacre/accuracy/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "nacre/bake/bake.h"
#include "nacre/bake/sampler.h"
#include "nacre/colour/cie_tables.h"

namespace nacre {
namespace {

// Gauss-Legendre with three nodes on [0, 1] (Abramowitz & Stegun, table 25.4).
struct QuadratureNode {
    double at;
    double share;
};
constexpr std::array<QuadratureNode, 3> quadrature{
    {{0.5 - 0.387298334620741689, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + 0.387298334620741689, 5.0 / 18.0}}};

// Where a mechanism's reflectance is not smooth in the wavelength, or not there at all.
struct Support {
    double from_nm;
    double to_nm;
};
struct SupportAt {
    Incidence incidence;
    Support operator()(const Palette& palette) const {
        const Lobe lobe = palette_lobe(palette, incidence);
        return {lobe.peak_nm - 0.5 * lobe.width_nm, lobe.peak_nm + 0.5 * lobe.width_nm};
    }
};

// One row per mechanism: reflectance at a wavelength, prepared for one angle.
struct ReflectanceAt {
    Incidence incidence;
    Lobe operator()(const Palette& palette) const { return palette_lobe(palette, incidence); }
};

Xyz plus(const Xyz& sum, double factor, const Xyz& term) {
    return {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z};
}

}  // namespace

Reference::Reference(const Job& job) : job_(job) {
    const LightSettings& light = job.light->settings;
    Xyz white;
    for (int nm = light.first_nm; nm <= light.last_nm; ++nm) {
        const auto& bars = colour_matching(light.observer, nm);
        const double power = light.power.at(nm);
        weights_.push_back({power * bars[0], power * bars[1], power * bars[2]});
        const double share = nm == light.first_nm || nm == light.last_nm ? 0.5 : 1.0;  // trapezia
        white = plus(white, share, weights_.back());
    }
    for (Xyz& weight : weights_) weight = plus({}, 1.0 / white.y, weight);
    white = plus({}, 1.0 / white.y, white);
    adaptation_ = adaptation_matrix(light.adaptation, white, xyz_from_chromaticity(d65_chromaticity));
}

Xyz Reference::weight_at(double nm) const {
    const double position = nm - job_.light->settings.first_nm;
    const auto cell = std::min(static_cast<std::size_t>(position), weights_.size() - 2);
    const double along = position - static_cast<double>(cell);
    return plus(plus({}, 1.0 - along, weights_[cell]), along, weights_[cell + 1]);
}

Xyz Reference::integral(const Mechanism& mechanism, const Incidence& incidence, double from_nm, double to_nm) const {
    const Lobe lobe = std::visit(ReflectanceAt{incidence}, mechanism);
    // The cosine of a narrow band bends within a nanometre.
    const double longest_nm = std::min(1.0, 0.125 * (to_nm - from_nm));
    Xyz sum;
    for (double left = from_nm; left < to_nm;) {
        const double right = std::min({std::floor(left) + 1.0, to_nm, left + longest_nm});
        if (!(right > left)) break;  // the rest is narrower than a double resolves
        for (const QuadratureNode& node : quadrature) {
            const double nm = left + node.at * (right - left);
            sum = plus(sum, node.share * (right - left) * lobe_reflectance(lobe, nm), weight_at(nm));
        }
        left = right;
    }
    return sum;
}

Xyz Reference::at(double x, double y) const {
    const Mechanism mechanism = mechanism_at(job_, x, y);
    const Incidence incidence = incidence_at(job_, x, y);
    const Support support = std::visit(SupportAt{incidence}, mechanism);
    const LightSettings& light = job_.light->settings;
    const double from_nm = std::max(support.from_nm, static_cast<double>(light.first_nm));
    const double to_nm = std::min(support.to_nm, static_cast<double>(light.last_nm));
    if (!(from_nm < to_nm)) return {};
    return adapt(adaptation_, integral(mechanism, incidence, from_nm, to_nm));
}

}  // namespace nacre
