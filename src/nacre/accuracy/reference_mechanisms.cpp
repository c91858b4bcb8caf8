#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/accuracy/reference.h"
#include "nacre/lut/sampler.h"
#include "nacre/shade/kinks.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;

// Gauss-Legendre with two nodes on [0, 1].
constexpr double gauss_nodes[2] = {0.5 - 0.288675134594812882, 0.5 + 0.288675134594812882};

Xyz plus_term(const Xyz& sum, double factor, const Xyz& term) {
    return {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z};
}

double sinc_squared(double t) {
    if (std::abs(t) < 1e-4) return 1.0 - pi * pi * t * t / 3.0;
    const double s = std::sin(pi * t) / (pi * t);
    return s * s;
}

}  // namespace

// A scattering layer at the wavelengths of the integral.
struct Reference::Scattering {
    Scatter scatter;
    std::vector<Wave> waves;
    std::unique_ptr<ScatterSolver> solver;
};

// One row per mechanism: its colour as a plane surface, or as one facet has it.
Xyz Reference::flat(const Mechanism& mechanism, const Geometry& geometry) const {
    struct Flat {
        const Reference& reference;
        const Mechanism& mechanism;
        const Geometry& geometry;
        Xyz operator()(const Palette& palette) const {
            return reference.integral(palette_lobe(palette, geometry.incidence));
        }
        Xyz operator()(const Film&) const { return reference.layered(mechanism, geometry.incidence); }
        Xyz operator()(const Stack&) const { return reference.layered(mechanism, geometry.incidence); }
        Xyz operator()(const Grating& grating) const { return reference.lines(grating, geometry.grating_u); }
        Xyz operator()(const Crystal&) const { return reference.layered(mechanism, geometry.incidence); }
        Xyz operator()(const Scatter&) const { return reference.scattered(mechanism, geometry.cos_scatter); }
        Xyz operator()(const MeasuredSpectra& spectra) const { return reference.measured(spectra, geometry.incidence); }
    };
    return std::visit(Flat{*this, mechanism, geometry}, static_cast<const MechanismModel&>(mechanism));
}

// Rings and spokes by the midpoint rule, those that are turned away not counted.
Xyz Reference::tilted(const Mechanism& mechanism, const Incidence& incidence) const {
    Mechanism plain = mechanism;
    plain.effects.tilt_deg = 0.0;
    if (!facets_ || !(facets_->first == plain)) {
        facets_.emplace(plain,
                        facet_curve([&](const Incidence& facet) { return flat(plain, facet); }, kinks_deg(plain)));
    }
    constexpr int rings = 240;
    constexpr int spokes = 180;
    const double tilt = mechanism.effects.tilt_deg * pi / 180.0;
    const double steepest = std::min(7.0 * tilt, 0.5 * pi);
    const double sin_theta = std::sin(incidence.theta_deg * pi / 180.0);
    Xyz sum;
    double visible = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double tau = steepest * (i + 0.5) / rings;
        const double density = std::exp(-0.5 * (tau / tilt) * (tau / tilt)) * std::sin(tau);
        for (int j = 0; j < spokes; ++j) {
            const double around = pi * (j + 0.5) / spokes;
            const double cos_facet = incidence.cos_theta * std::cos(tau) + sin_theta * std::sin(tau) * std::cos(around);
            if (cos_facet <= 0.0) continue;
            sum = plus_term(sum, density * cos_facet, facets_->second.at(std::sqrt(std::min(cos_facet, 1.0))));
            visible += density * cos_facet;
        }
    }
    return visible > 0.0 ? plus_term({}, 1.0 / visible, sum) : flat(plain, incidence);
}

// Every order's line, wave by wave where it is bright; far away by its mean, 1 / (2 pi^2 t^2).
Xyz Reference::lines(const Grating& grating, double u) const {
    constexpr double far = 200.0;  // in widths of a line: what its waves sum to beyond is 2e-7 of it
    constexpr double waves_per_step = 0.2;
    const LightSettings& light = job_.light->settings;
    const double across = grating.azimuth_deg * pi / 180.0;
    const double path_nm = u * share_across(grating) * grating.period_nm;
    const double along_nm = 1e3 * grating.groove_length_um * u * std::sin(across);
    Xyz sum;
    const auto add = [&](int order, double nm, double length_nm, bool is_mean) {
        const double t = grating.grooves * (path_nm / nm - order);
        const double line = is_mean ? 1.0 / (2.0 * pi * pi * t * t) : sinc_squared(t);
        const double density = grating_efficiency(grating, order, nm) * grating.grooves * grating.period_nm / nm *
                               line * std::exp(-pi * (along_nm / nm) * (along_nm / nm));
        sum = plus_term(sum, length_nm * density, weight_at(nm));
    };
    for (const int magnitude : counted_orders(grating, light.first_nm)) {
        for (const int order : {magnitude, -magnitude}) {
            for (double left = light.first_nm; left < light.last_nm;) {
                const double t = grating.grooves * (path_nm / left - order);
                const double per_nm = grating.grooves * path_nm / (left * left);
                // Where ripples are broad it takes them all: nothing averages them, and there may be no other light.
                constexpr double least_ripples_per_nm = 0.05;
                const bool is_far = per_nm > least_ripples_per_nm && (t > far + per_nm || t < -far);
                const double whole = std::min(next_kink(left), static_cast<double>(light.last_nm));
                double right = whole;
                if (!is_far) right = std::min(whole, left + waves_per_step / std::max(per_nm, 1e-9));
                if (!is_far && t > far) right = std::min(whole, left + 1.0 / std::max(per_nm, 1e-9));
                for (const double at : gauss_nodes)
                    add(order, std::lerp(left, right, at), 0.5 * (right - left), is_far);
                left = right;
            }
            if (magnitude == 0) break;
        }
    }
    if (grating.azimuth_deg > 0.0 && grating.groove_length_um == 0.0 && u > 0.0) return {};
    return sum;
}

Xyz Reference::scattered(const Mechanism& mechanism, double cos_scatter) const {
    const auto& scatter = std::get<Scatter>(mechanism);
    if (!scattering_ || !(scattering_->scatter == scatter)) {
        auto made = std::make_shared<Scattering>();
        made->scatter = scatter;
        const LightSettings& light = job_.light->settings;
        // Ripples of a single sphere are as fine as its size parameter is large.
        const double size = 2.0 * pi * scatter.radius_nm * scatter.medium.at(550.0).real() / 550.0;
        const int parts = scatter.radius_spread > 0.0 ? 1 : std::clamp(static_cast<int>(size / 100.0), 1, 64);
        std::vector<double> wavelengths_nm;
        for (double nm = light.first_nm, next_nm = 0.0; nm < light.last_nm; nm = next_nm) {
            next_nm = next_kink(nm);
            const double length_nm = next_nm - nm;
            for (int part = 0; part < parts; ++part) {
                for (const double at : gauss_nodes)
                    made->waves.push_back({nm + length_nm * (part + at) / parts, 0.5 * length_nm / parts});
            }
        }
        for (const Wave& wave : made->waves) wavelengths_nm.push_back(wave.nm);
        constexpr int enough_sizes = 96;
        const int sizes = scatter.radius_spread > 0.0 ? std::max(enough_sizes, 2 * job_.sampling.radii) : 1;
        made->solver = std::make_unique<ScatterSolver>(scatter, wavelengths_nm, sizes);
        scattering_ = std::move(made);
    }
    std::vector<double> seen(scattering_->waves.size());
    scattering_->solver->seen(cos_scatter, mechanism.effects.polarisation, seen);
    Xyz sum;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Wave& wave = scattering_->waves[i];
        sum = plus_term(sum, seen[i] * wave.length_nm, weight_at(wave.nm));
    }
    return sum;
}

// Spectra, lamp and colour matching functions are straight between these: two nodes are exact.
Xyz Reference::measured(const MeasuredSpectra& spectra, const Incidence& incidence) const {
    const LightSettings& light = job_.light->settings;
    std::vector<double> borders(spectra.wavelength_nm);
    borders.insert(borders.end(), kinks_nm_.begin(), kinks_nm_.end());
    std::sort(borders.begin(), borders.end());
    Xyz sum;
    for (std::size_t i = 1; i < borders.size(); ++i) {
        if (borders[i - 1] < light.first_nm || borders[i] > light.last_nm) continue;
        for (const double at : gauss_nodes) {
            const double nm = std::lerp(borders[i - 1], borders[i], at);
            const double reflectance = measured_reflectance(spectra, incidence.theta_deg, nm);
            sum = plus_term(sum, 0.5 * (borders[i] - borders[i - 1]) * reflectance, weight_at(nm));
        }
    }
    return sum;
}

}  // namespace nacre
