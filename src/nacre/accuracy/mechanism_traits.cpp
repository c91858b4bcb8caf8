#include "nacre/accuracy/mechanism_traits.h"

#include <algorithm>
#include <variant>

#include "nacre/shade/layered_colour.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// The reference solves every layer at every wavelength, several times per fringe. Up to a hundred layers and a hundred
// fringes it takes as long as for a film (empirical).
double layered_cost(const Job& job, const Mechanism& mechanism) {
    const double layers = expanded_layers(even_system(mechanism));
    const double fringes = fringe_count(mechanism, job.light->settings);
    return job.sampling.thickness_samples * std::max(1.0, layers / 100.0) * std::max(1.0, fringes / 100.0);
}

// Mie's series has as many terms as the radius is long; a spread of radii counts as 96 of them (empirical).
// On a parameter axis every point has other spheres, whose series are not kept: 50 times as much (empirical).
double scattered_cost(const Job& job, const Mechanism& mechanism) {
    const auto& scatter = std::get<Scatter>(mechanism);
    const double cost = 1e-3 * scatter.radius_nm * (scatter.radius_spread > 0.0 ? 96.0 : 1.0);
    return job.moves_material() ? 50.0 * cost : cost;
}

// The compiler names a mechanism that has no row.
struct TraitsOf {
    MechanismTraits operator()(const Palette&) const { return {.is_closed_form = true}; }
    MechanismTraits operator()(const Film&) const { return {.reference_cost = layered_cost}; }
    MechanismTraits operator()(const Stack&) const { return {.reference_cost = layered_cost}; }
    MechanismTraits operator()(const Grating&) const { return {}; }
    MechanismTraits operator()(const Crystal&) const { return {.has_slices = true, .reference_cost = layered_cost}; }
    MechanismTraits operator()(const Scatter&) const { return {.reference_cost = scattered_cost}; }
    MechanismTraits operator()(const MeasuredSpectra&) const { return {}; }
};

}  // namespace

MechanismTraits traits_of(const Mechanism& mechanism) {
    return std::visit(TraitsOf{}, static_cast<const MechanismModel&>(mechanism));
}

}  // namespace nacre
