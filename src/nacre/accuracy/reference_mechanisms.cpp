#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/accuracy/reference.h"
#include "nacre/colour/xyz_sums.h"
#include "nacre/lut/sampler.h"
#include "nacre/shade/kinks.h"

namespace nacre {
namespace {

using std::numbers::pi;

}  // namespace

// One row per mechanism: its colour as a plane surface, or as one facet has it.
Xyz Reference::flat(const Mechanism& mechanism, const Geometry& geometry) const {
    struct Flat {
        const Reference& reference;
        const Mechanism& mechanism;
        const Geometry& geometry;
        Xyz operator()(const Palette& palette) const {
            return reference.band(palette_lobe(palette, geometry.incidence));
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

namespace {

// How much of the facets that are `gamma` off the line of sight there is around it, that line being `theta` off the
// surface's normal: the integral of exp(-tau^2 / (2 tilt^2)), tau being what a facet is off that normal, by
// sin^2(tau / 2) = sin^2((theta - gamma) / 2) + sin(theta) sin(gamma) sin^2(phi / 2). All in radians.
double facets_around(double theta, double gamma, double tilt, double steepest) {
    constexpr int spokes = 16;  // of half a turn, or of 6.5 standard deviations
    const double off = theta - gamma;
    const double across = std::sin(theta) * std::sin(gamma);
    const double reach = std::sin(0.5 * (steepest + off)) * std::sin(0.5 * (steepest - off)) / across;
    const double arc = reach < 1.0 ? 2.0 * std::asin(std::sqrt(std::max(reach, 0.0))) : pi;
    double sum = 0.0;
    for (int spoke = 0; spoke < spokes; ++spoke) {
        const double near = std::sin(0.5 * off);
        const double aside = std::sin(0.5 * arc * (spoke + 0.5) / spokes);
        const double tau = 2.0 * std::asin(std::min(std::sqrt(near * near + across * aside * aside), 1.0));
        sum += std::exp(-0.5 * (tau / tilt) * (tau / tilt));
    }
    return arc / spokes * sum;
}

}  // namespace

// Around the line of sight rather than the surface's normal, by Simpson's rule: then none is turned away.
Xyz Reference::tilted(double tilt_deg, const XyzCurve& facet, const Incidence& incidence) const {
    constexpr int most_rings = 4096;
    const double theta = incidence.theta_deg * pi / 180.0;
    const double tilt = tilt_deg * pi / 180.0;
    const double steepest = std::min(6.5 * tilt, 0.5 * pi);
    const double from = std::max(theta - steepest, 0.0);
    const double to = std::min(theta + steepest, 0.5 * pi);
    for (int rings = 32;; rings *= 2) {
        std::array<Xyz, 2> sums;  // of all rings, and of every second one
        std::array<double, 2> visible{};
        for (int ring = 1; ring < rings; ++ring) {  // at either end there is nothing
            const double gamma = std::lerp(from, to, static_cast<double>(ring) / rings);
            const double there = facets_around(theta, gamma, tilt, steepest) * std::sin(gamma) * std::cos(gamma);
            const Xyz seen = facet.at(std::sqrt(std::cos(gamma)));
            const double share = ring % 2 == 1 ? 4.0 : 2.0;
            const double share_of_seconds = ring % 2 == 1 ? 0.0 : ring % 4 == 2 ? 8.0 : 4.0;
            for (const auto& [i, weight] :
                 {std::pair{std::size_t{0}, share * there}, {std::size_t{1}, share_of_seconds * there}}) {
                add(sums[i], weight, seen);
                visible[i] += weight;
            }
        }
        if (!(visible[1] > 0.0)) return facet.at(std::sqrt(incidence.cos_theta));
        const Xyz mean = scaled(sums[0], 1.0 / visible[0]);
        if (rings >= most_rings || !(doubt(mean, scaled(sums[1], 1.0 / visible[1])) > 1.0)) return mean;
    }
}

namespace {

// What an eye sees of rough facets, as rough_facets() has it; light and eye are above the surface.
struct RoughSurface {
    double alpha;
    double cos_eye;

    // Per solid angle, but for a factor.
    double density(double cos_facet) const {
        const double d = alpha * alpha * cos_facet * cos_facet + (1.0 - cos_facet) * (1.0 + cos_facet);
        return alpha * alpha / (d * d);
    }
    // Smith's (1 + L(v)) / (1 + L(v) + L(l)); along the surface L(v) is beyond all bounds.
    double seen_and_lit(double cos_light) const {
        if (cos_eye == 0.0) return 1.0;
        const auto smith = [&](double cosine) {
            const double slope = alpha * std::sqrt((1.0 - cosine) * (1.0 + cosine)) / cosine;
            return 0.5 * (std::sqrt(1.0 + slope * slope) - 1.0);
        };
        return (1.0 + smith(cos_eye)) / (1.0 + smith(cos_eye) + smith(cos_light));
    }
};

// Angles between facet and surface between which rules are taken: farther and farther apart in slopes of alpha, and
// where light begins to come from below.
std::vector<double> ring_borders(double theta, double alpha) {
    constexpr double steepest_border = 50.0;
    const double last = 0.5 * (0.5 * pi + theta);
    std::vector<double> borders{0.0, 0.5 * (0.5 * pi - theta), last};
    for (double x = 0.5; x * alpha < steepest_border && std::atan(x * alpha) < last; x *= 3.0)
        borders.push_back(std::atan(x * alpha));
    std::sort(borders.begin(), borders.end());
    return borders;
}

}  // namespace

// Around the surface's normal, ring by ring: twice as many points on and of each until the mean agrees.
Xyz Reference::rough(double roughness, const XyzCurve& facet, const Incidence& incidence) const {
    constexpr double mirror = 1e-4;
    constexpr int most_rings = 256;
    if (roughness < mirror) return facet.at(std::sqrt(incidence.cos_theta));
    const RoughSurface surface{roughness * roughness, incidence.cos_theta};
    const double theta = incidence.theta_deg * pi / 180.0;
    const std::vector<double> borders = ring_borders(theta, surface.alpha);
    Xyz half;
    for (int count = 4;; count *= 2) {
        Xyz sum;
        double visible = 0.0;
        for (std::size_t i = 1; i < borders.size(); ++i) {
            for (const GaussPoint& ring : unit_gauss_legendre(count)) {
                const double tau = std::lerp(borders[i - 1], borders[i], ring.at);
                const double along = std::cos(tau) * incidence.cos_theta;
                const double across = std::sin(tau) * std::sin(theta);
                // The light that a facet mirrors comes from above where 2 cos(h, v) cos(h, n) > cos(v, n).
                const double least = 0.5 * incidence.cos_theta / std::cos(tau);
                const double arc = across > 0.0 ? std::acos(std::clamp((least - along) / across, -1.0, 1.0)) : pi;
                const double there =
                    (borders[i] - borders[i - 1]) * ring.weight * surface.density(std::cos(tau)) * std::sin(tau);
                for (const GaussPoint& spoke : unit_gauss_legendre(2 * count)) {
                    const double cos_facet = std::min(along + across * std::cos(arc * spoke.at), 1.0);
                    const double cos_light = 2.0 * cos_facet * std::cos(tau) - incidence.cos_theta;
                    if (!(cos_light > 0.0)) continue;
                    const double weight =
                        there * arc * spoke.weight * cos_facet * surface.seen_and_lit(std::min(cos_light, 1.0));
                    add(sum, weight, facet.at(std::sqrt(cos_facet)));
                    visible += weight;
                }
            }
        }
        if (!(visible > 0.0)) return facet.at(std::sqrt(incidence.cos_theta));
        const Xyz mean = scaled(sum, 1.0 / visible);
        if (count >= most_rings || (count > 4 && !(doubt(mean, half) > 1.0))) return mean;
        half = mean;
    }
}

Xyz Reference::mean_of_facets(const Mechanism& mechanism, const Incidence& incidence) const {
    const Relief& relief = mechanism.effects.relief;
    Mechanism plain = mechanism;
    plain.effects.relief = {};
    if (!facets_ || !(facets_->first == plain)) {
        facets_.emplace(plain,
                        facet_curve([&](const Incidence& facet) { return flat(plain, facet); }, kinks_deg(plain)));
    }
    const XyzCurve& facet = facets_->second;
    return relief.roughness > 0.0 ? rough(relief.roughness, facet, incidence)
                                  : tilted(relief.tilt_deg, facet, incidence);
}

namespace {

// More radii than a bake has, whose mean converges as fast as a Gaussian falls, and enough where it left them out.
int sizes_of_reference(int radii) {
    constexpr int enough = 12;
    constexpr int at_least_more = 4;
    return radii == 1 ? enough : radii + std::max(at_least_more, radii / 2);
}

}  // namespace

struct Reference::Scattering {
    Scatter scatter;
    int sizes = 1;
    std::map<std::size_t, ScatterSolver> solvers{};  // by the number of wavelengths
    int most_cells = 0;
    int cells = 0;  // to begin with

    std::vector<double> seen(const std::vector<double>& nm, double cos_scatter, Polarisation polarisation) {
        std::vector<double> values(nm.size());
        solvers.try_emplace(nm.size(), scatter, nm, sizes).first->second.seen(cos_scatter, polarisation, values);
        return values;
    }
};

// Of a single sphere some resonances are narrower than any step; the sum of their light is small.
Xyz Reference::scattered(const Mechanism& mechanism, double cos_scatter) const {
    const auto& scatter = std::get<Scatter>(mechanism);
    const bool has_sizes = scatter.radius_spread > 0.0;
    const int sizes = has_sizes ? sizes_of_reference(job_.sampling.radii) : 1;
    if (!scattering_ || !(scattering_->scatter == scatter)) {
        // What is kept of every wavelength is as long as its spheres are large.
        const double length = sizes * largest_size_parameter(scatter, job_.light->settings.first_nm, sizes);
        const int most_cells = static_cast<int>(std::clamp(4e6 / length, 1024.0, 16384.0));
        scattering_ = std::make_shared<Scattering>(Scattering{scatter, sizes, {}, most_cells});
    }
    const auto spectrum = [&](const std::vector<double>& nm) {
        return scattering_->seen(nm, cos_scatter, mechanism.effects.polarisation);
    };
    return integral(has_sizes ? 8.0 : 1.0, scattering_->cells, spectrum, scattering_->most_cells);
}

// Spectra, lamp and colour matching functions are straight between these: the rule is exact.
void Reference::weigh(const std::vector<double>& measured_nm) const {
    const LightSettings& light = job_.light->settings;
    std::vector<double> borders(measured_nm);
    borders.insert(borders.end(), kinks_nm_.begin(), kinks_nm_.end());
    std::sort(borders.begin(), borders.end());
    measured_ = {measured_nm, {}, std::vector<Xyz>(measured_nm.size())};
    for (std::size_t i = 1; i < borders.size(); ++i) {
        if (borders[i - 1] < light.first_nm || borders[i] > light.last_nm) continue;
        const auto above = std::upper_bound(measured_nm.begin() + 1, measured_nm.end() - 1, borders[i - 1]);
        const auto right = static_cast<std::size_t>(above - measured_nm.begin());
        for (const GaussPoint& point : rule_) {
            const double nm = std::lerp(borders[i - 1], borders[i], point.at);
            const Xyz weight = scaled(weight_at(nm), point.weight * (borders[i] - borders[i - 1]));
            const double along = (nm - measured_nm[right - 1]) / (measured_nm[right] - measured_nm[right - 1]);
            const double share = std::clamp(along, 0.0, 1.0);  // what was measured last is held
            add(measured_.weights[right - 1], 1.0 - share, weight);
            add(measured_.weights[right], share, weight);
        }
    }
}

Xyz Reference::measured(const MeasuredSpectra& spectra, const Incidence& incidence) const {
    if (measured_.nm != spectra.wavelength_nm) weigh(spectra.wavelength_nm);
    Xyz sum;
    for (std::size_t i = 0; i < measured_.nm.size(); ++i)
        add(sum, measured_reflectance(spectra, incidence.theta_deg, measured_.nm[i]), measured_.weights[i]);
    return sum;
}

}  // namespace nacre
