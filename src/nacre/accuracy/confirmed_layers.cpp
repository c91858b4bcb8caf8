#include "nacre/accuracy/confirmed_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nacre {
namespace {

// What the two may differ by: far above the rounding of either, far below what a texel shows.
constexpr double most_difference = 1e-9;

bool are_near(const Response& one, const Response& other) {
    return std::abs(one.reflectance_s - other.reflectance_s) <= most_difference &&
           std::abs(one.reflectance_p - other.reflectance_p) <= most_difference &&
           std::abs(one.transmittance_s - other.transmittance_s) <= most_difference &&
           std::abs(one.transmittance_p - other.transmittance_p) <= most_difference;
}

}  // namespace

ConfirmedLayers::ConfirmedLayers(LayerEnsemble ensemble)
    : ensemble_(std::move(ensemble)), is_twin_short_(expanded_layers(ensemble_.systems.front()) <= most_twin_layers) {}

// The golden ratio's sequence: evenly over all, and in no step with anything.
std::size_t ConfirmedLayers::pick(std::size_t count) {
    constexpr double golden = 0.61803398874989485;
    const double turns = golden * static_cast<double>(++picks_);
    return static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(count));
}

bool ConfirmedLayers::confirms(const LayerSystem& system, const Incidence& incidence,
                               const std::vector<double>& wavelengths_nm, const std::vector<Response>& responses) {
    constexpr int wavelengths = 2;  // chosen: a LUT has a hundred colours that are looked at
    for (int i = 0; i < wavelengths; ++i) {
        const std::size_t at = pick(wavelengths_nm.size());
        if (!are_near(responses[at], multilayer_response(system, incidence, wavelengths_nm[at]))) return false;
    }
    return true;
}

std::vector<Response> ConfirmedLayers::at(const Incidence& incidence, const std::vector<double>& wavelengths_nm) {
    constexpr std::size_t most_kept = std::size_t{1} << 19U;  // chosen: some ten megabytes
    const std::size_t systems = ensemble_.systems.size();
    auto& solvers = solvers_[wavelengths_nm.size()];
    const bool are_kept = systems * wavelengths_nm.size() <= most_kept;
    const std::size_t looked_at = is_twin_short_ ? pick(systems) : systems;
    std::vector<Response> one(wavelengths_nm.size());
    std::vector<Response> mean(systems == 1 ? 0 : wavelengths_nm.size());
    for (std::size_t i = 0; i < systems; ++i) {
        const LayerSystem& system = ensemble_.systems[i];
        if (was_refuted_) {
            std::transform(wavelengths_nm.begin(), wavelengths_nm.end(), one.begin(),
                           [&](double nm) { return multilayer_response(system, incidence, nm); });
        } else if (are_kept) {
            if (solvers.size() == i) solvers.emplace_back(system, wavelengths_nm);
            solvers[i].responses(incidence, one);
        } else {
            MultilayerSolver(system, wavelengths_nm).responses(incidence, one);
        }
        if (!was_refuted_ && i == looked_at && !confirms(system, incidence, wavelengths_nm, one)) {
            was_refuted_ = true;
            return at(incidence, wavelengths_nm);
        }
        if (systems == 1) return one;
        for (std::size_t k = 0; k < one.size(); ++k) add(mean[k], ensemble_.shares[i], one[k]);
    }
    return mean;
}

}  // namespace nacre
