#include "nacre/shade/layered_colour.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nacre/base/gauss_points.h"
#include "nacre/optics/reversed.h"
#include "nacre/shade/shading.h"

namespace nacre {
namespace {

const MetalBase* metal_base(const Effects& effects) {
    return effects.base ? std::get_if<MetalBase>(&*effects.base) : nullptr;
}

const Base* diffuse_base(const Effects& effects) {
    return effects.base && metal_base(effects) == nullptr ? &*effects.base : nullptr;
}

// What was the substrate becomes a layer in which nothing interferes, and nothing is lost.
void add_metal(const MetalBase& base, LayerSystem& system) {
    LayerNode gap;
    gap.medium = system.substrate;
    gap.is_incoherent = true;
    system.nodes.push_back(gap);
    system.curves.push_back(base.metal);
    const auto curve = static_cast<int>(system.curves.size()) - 1;
    system.media.push_back({curve, curve, 0.0, Mixing::index});
    system.substrate = static_cast<int>(system.media.size()) - 1;
}

// Domains of a crystal: each is regular, and their spacings are a normal variable.
LayerEnsemble crystal_domains(const Crystal& crystal, int count, int slices) {
    LayerEnsemble ensemble;
    const double spacing_nm = plane_spacing_nm(crystal);
    for (const GaussPoint& point : normal_points(count)) {
        if (!(point.weight > 0.0)) continue;
        const double deviation_nm = crystal.thickness_spread_nm * point.at;
        const double factor = std::max(spacing_nm + deviation_nm, 0.05 * spacing_nm) / spacing_nm;
        Crystal domain = crystal;
        domain.diameter_nm *= factor;
        domain.spacing_nm *= factor;
        ensemble.systems.push_back(layer_system(domain, slices));
        ensemble.shares.push_back(point.weight);
    }
    return ensemble;
}

// Whether either of the materials that a medium is mixed of has a property.
template <typename Has>
bool has_either(const LayerSystem& system, int medium, const Has& has) {
    const Medium& mixed = system.media[static_cast<std::size_t>(medium)];
    return has(system.curves[static_cast<std::size_t>(mixed.curve)]) ||
           (mixed.share != 0.0 && has(system.curves[static_cast<std::size_t>(mixed.other)]));
}

bool is_dispersive(const LayerSystem& system, int medium) {
    return has_either(system, medium, [](const Index& index) { return index.is_dispersive(); });
}

bool absorbs(const LayerSystem& system, int medium) {
    return has_either(system, medium, [](const Index& index) {
        return index.is_constant() ? index.constant.imag() > 0.0 : !index.curve->is_lossless();
    });
}

}  // namespace

bool is_irregular(const Mechanism& mechanism) {
    return thickness_spread_nm(mechanism) > 0.0;
}

LayerSystem even_system(const Mechanism& mechanism, std::span<const std::size_t> incoherent, int slices) {
    return std::move(layer_ensemble(mechanism, 1, incoherent, slices).systems.front());
}

LayerEnsemble layer_ensemble(const Mechanism& mechanism, int samples, std::span<const std::size_t> incoherent,
                             int slices) {
    LayerSystem even = shading_of(mechanism).layers(mechanism, slices);
    // What lies below a thick layer is gone where those are left out.
    for (const std::size_t node : incoherent) {
        if (node < even.nodes.size()) even.nodes[node].is_incoherent = true;
    }
    const double spread_nm = thickness_spread_nm(mechanism);
    LayerEnsemble ensemble;
    if (spread_nm == 0.0 || samples < 2) {
        ensemble = {{std::move(even)}, {1.0}};
    } else if (const auto* crystal = std::get_if<Crystal>(&mechanism)) {
        ensemble = crystal_domains(*crystal, samples, slices);
    } else {
        ensemble = irregular_systems(even, spread_nm, samples);
    }
    if (const MetalBase* metal = metal_base(mechanism.effects)) {
        for (LayerSystem& system : ensemble.systems) add_metal(*metal, system);
    }
    return ensemble;
}

ThicknessSampleCounts thickness_sample_counts(const Mechanism& mechanism) {
    if (std::holds_alternative<Crystal>(mechanism)) return thickness_sample_counts(1);
    const LayerSystem uneven = layer_ensemble(mechanism, 2).systems.front();  // its repeats are written out
    return thickness_sample_counts(
        static_cast<std::size_t>(std::count_if(uneven.nodes.begin(), uneven.nodes.end(), [](const LayerNode& node) {
            return node.repeat == 0 && !node.is_incoherent;
        })));
}

std::vector<double> base_factors(const Base& base, const LayerEnsemble& ensemble,
                                 std::span<const double> wavelengths_nm, int points, Work* work) {
    constexpr double any_nm = 550.0;
    const std::size_t count = wavelengths_nm.size();
    const auto rule = unit_gauss_legendre(points);
    std::vector<double> reflected(count, 0.0);  // of light that comes evenly from below
    std::vector<double> passed(count, 0.0);
    std::vector<Response> responses(count);
    for (std::size_t member = 0; member < ensemble.systems.size(); ++member) {
        const double share = ensemble.shares[member];
        const LayerSystem from_below = reversed(ensemble.systems[member]);
        const MultilayerSolver solver(from_below, wavelengths_nm);
        // Directions by the square of their cosine: then all of them count alike. Beyond the critical angle nothing
        // gets out.
        const double ratio = from_below.index_at(from_below.substrate, any_nm).real() /
                             from_below.index_at(from_below.incident, any_nm).real();
        const double critical = ratio < 1.0 ? (1.0 - ratio) * (1.0 + ratio) : 0.0;
        const auto add = [&](double from, double to) {
            if (!(to > from)) return;
            for (const GaussPoint& point : rule) {
                solver.responses(Incidence::from_cos(std::sqrt(std::lerp(from, to, point.at))), responses);
                const double weight = share * (to - from) * point.weight;
                for (std::size_t i = 0; i < count; ++i) {
                    reflected[i] += weight * responses[i].reflectance();
                    passed[i] += weight * responses[i].transmittance();
                }
                if (work == nullptr) continue;
                ++work_of(work->effects, Effect::base).points;
                ++work_of(work->effects, Effect::base).spectra;
                work->samples += count;
            }
        };
        add(0.0, critical);
        add(critical, 1.0);
    }
    std::vector<double> factors(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double rho = diffuse_reflectance(base, wavelengths_nm[i]);
        // A white base under layers that let nothing out: then nothing comes in either.
        const double left = std::max(1.0 - rho * reflected[i], 1e-15);
        factors[i] = std::min(rho * passed[i] / left, 1.0);
    }
    return factors;
}

LayeredColour::LayeredColour(const Mechanism& mechanism, SpectralSampling sampling)
    : sampling_(std::move(sampling)),
      effects_(mechanism.effects),
      ensemble_(layer_ensemble(mechanism, sampling_.thickness_samples, sampling_.incoherent_layers, sampling_.slices)) {
}

LayeredColour::Band& LayeredColour::band_at(std::size_t index, Work* work) {
    Band& band = bands_[index];
    if (band.solvers != nullptr) return band;
    const Nodes& nodes = sampling_.nodes[index];
    for (std::size_t other = 0; other < bands_.size(); ++other) {
        if (sampling_.nodes[other] == nodes && bands_[other].solvers != nullptr) band.solvers = bands_[other].solvers;
    }
    if (band.solvers == nullptr) band.solvers = layer_solvers(sampling_.kept.get(), ensemble_.systems, nodes);
    if (const Base* base = diffuse_base(effects_)) {
        const int points = sampling_.base_directions;
        band.base_factors = sampling_.kept != nullptr
                                ? sampling_.kept->base_factors(*base, ensemble_, nodes, points, work)
                                : base_factors(*base, ensemble_, nodes->wavelength_nm, points, work);
    }
    return band;
}

Xyz LayeredColour::with_base(const Band& band, const SpectralNodes& nodes, const Incidence& incidence) const {
    std::vector<Response> responses(nodes.wavelength_nm.size());
    Xyz sum;
    for (std::size_t member = 0; member < band.solvers->size(); ++member) {
        (*band.solvers)[member].responses(incidence, responses);
        const double share = ensemble_.shares[member];
        for (std::size_t i = 0; i < responses.size(); ++i) {
            const double seen = share * (reflectance_of(responses[i], effects_.polarisation) +
                                         transmittance_of(responses[i], effects_.polarisation) * band.base_factors[i]);
            sum = {sum.x + seen * nodes.x[i], sum.y + seen * nodes.y[i], sum.z + seen * nodes.z[i]};
        }
    }
    return sum;
}

Xyz LayeredColour::at(const Incidence& incidence, Work* work) {
    const std::size_t index = band_of(incidence);
    const SpectralNodes& nodes = *sampling_.nodes[index];
    const Band& band = band_at(index, work);
    Xyz sum;
    if (!band.base_factors.empty()) {
        sum = with_base(band, nodes, incidence);
    } else {
        for (std::size_t member = 0; member < band.solvers->size(); ++member) {
            const auto [x, y, z] = (*band.solvers)[member].weighted(
                incidence, {nodes.x.data(), nodes.y.data(), nodes.z.data()}, effects_.observed, effects_.polarisation);
            const double share = ensemble_.shares[member];
            sum = {sum.x + share * x, sum.y + share * y, sum.z + share * z};
        }
    }
    if (work != nullptr) count(nodes, *work);
    return sum;
}

void LayeredColour::count(const SpectralNodes& nodes, Work& work) const {
    const auto spectra = static_cast<std::uint64_t>(ensemble_.systems.size());
    const auto samples = static_cast<std::uint64_t>(nodes.count) * spectra;
    ++work.spectra;
    work.samples += samples;
    if (effects_.polarisation == Polarisation::mean)
        work_of(work.effects, Effect::polarisation).polarisations += spectra;
    if (ensemble_.systems.size() > 1) work_of(work.effects, Effect::thickness_spread).spectra += spectra;
    if (effects_.base) ++work_of(work.effects, Effect::base).spectra;
    const LayerSystem& system = ensemble_.systems.front();
    std::uint64_t incoherent = 0;
    for (const LayerNode& node : system.nodes) {
        // Of the gap above a metal nothing counts but its index.
        if (node.repeat == 0 && is_dispersive(system, node.medium))
            work_of(work.effects, Effect::dispersion).layers += samples;
        if (node.repeat > 0 || !(node.thickness_nm > 0.0)) continue;
        if (node.is_incoherent) ++incoherent;
        if (absorbs(system, node.medium)) work_of(work.effects, Effect::absorption).layers += samples;
    }
    for (const int half_space : {system.incident, system.substrate}) {
        if (is_dispersive(system, half_space)) work_of(work.effects, Effect::dispersion).layers += samples;
    }
    // Layers that were made incoherent, like nodes, are not part of the scene.
    incoherent -= std::min<std::uint64_t>(incoherent, sampling_.incoherent_layers.size());
    work_of(work.effects, Effect::incoherent_layers).layers += spectra * incoherent;
}

std::uint64_t LayeredColour::samples(const Incidence& incidence) const {
    return static_cast<std::uint64_t>(sampling_.nodes[band_of(incidence)]->count) * ensemble_.systems.size();
}

namespace {

// With twice as many directions until no factor changes: at a single wavelength nothing averages over what too few miss
// of the fringes of many layers. Of uneven layers there are none.
std::vector<double> converged_base_factors(const Base& base, const LayerEnsemble& ensemble,
                                           std::span<const double> wavelengths_nm) {
    constexpr int directions_of_uneven_layers = 16;
    constexpr int fewest_directions = 64;
    constexpr int most_directions = 8192;  // chosen: factors of 51 layers agree at 4096
    constexpr double tolerance = 1e-7;     // of a factor; chosen
    constexpr double most_effort = 1e9;    // layers times wavelengths times directions: some seconds; chosen
    if (ensemble.systems.size() > 1) return base_factors(base, ensemble, wavelengths_nm, directions_of_uneven_layers);
    const double per_direction =
        static_cast<double>(ensemble.systems.front().nodes.size()) * static_cast<double>(wavelengths_nm.size());
    const auto is_affordable = [&](int directions) {
        return directions <= most_directions && directions * per_direction <= most_effort;
    };
    std::vector<double> factors = base_factors(base, ensemble, wavelengths_nm, fewest_directions);
    for (int directions = 2 * fewest_directions; is_affordable(directions); directions *= 2) {
        std::vector<double> more = base_factors(base, ensemble, wavelengths_nm, directions);
        double largest = 0.0;
        for (std::size_t i = 0; i < more.size(); ++i) largest = std::max(largest, std::abs(more[i] - factors[i]));
        factors = std::move(more);
        if (!(largest > tolerance)) break;
    }
    return factors;
}

}  // namespace

LayeredSpectra::LayeredSpectra(const Mechanism& mechanism, std::span<const double> wavelengths_nm, int samples)
    : count_(wavelengths_nm.size()) {
    const LayerEnsemble ensemble = layer_ensemble(mechanism, samples, {}, spectrum_slices);
    shares_ = ensemble.shares;
    for (const LayerSystem& system : ensemble.systems) solvers_.emplace_back(system, wavelengths_nm);
    const Base* base = diffuse_base(mechanism.effects);
    if (base != nullptr) base_factors_ = converged_base_factors(*base, ensemble, wavelengths_nm);
}

std::vector<Response> LayeredSpectra::at(const Incidence& incidence) const {
    std::vector<Response> mean(count_);
    std::vector<Response> one(count_);
    for (std::size_t member = 0; member < solvers_.size(); ++member) {
        solvers_[member].responses(incidence, one);
        for (std::size_t i = 0; i < count_; ++i) add(mean[i], shares_[member], one[i]);
    }
    for (std::size_t i = 0; i < base_factors_.size(); ++i) {
        mean[i].reflectance_s += mean[i].transmittance_s * base_factors_[i];
        mean[i].reflectance_p += mean[i].transmittance_p * base_factors_[i];
        mean[i].transmittance_s = mean[i].transmittance_p = 0.0;
    }
    return mean;
}

}  // namespace nacre
