#include "nacre/accuracy/mechanism_traits.h"

#include <algorithm>
#include <variant>

#include "nacre/shade/layered_colour.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// The reference solves every layer at two wavelengths per nanometre, or at more than thirty per fringe, and has the
// scalar solver confirm some (empirical: on average over the angles).
double layered_cost(const Job& job, const Mechanism& mechanism) {
    constexpr double least_wavelengths = 940.0;
    constexpr double per_fringe = 32.0;
    constexpr double with_confirmation = 4.0;
    const double fringes = fringe_count(mechanism, job.light->settings);
    return with_confirmation * std::max(least_wavelengths, per_fringe * fringes) * job.sampling.thickness_samples *
           effort_per_sample(mechanism, job.sampling.slices);
}

// Of a spread of radii the reference has at least 12; a sphere takes as much as so many films (empirical). On a
// parameter axis every point has other spheres, whose series are not kept: 50 times as much (empirical).
double scattered_cost(const Job& job, const Mechanism& mechanism) {
    constexpr double wavelengths = 470.0;
    constexpr double of_a_sphere = 4.0;
    const bool has_spread = std::get<Scatter>(mechanism).radius_spread > 0.0;
    const double cost = of_a_sphere * wavelengths * (has_spread ? std::max(12.0, 2.0 * job.sampling.radii) : 1.0);
    return job.moves_material() ? 50.0 * cost : cost;
}

// Three points per nanometre, each with a cosine (empirical). The closed form is exact to nine digits, so that few
// points do.
double band_cost(const Job&, const Mechanism&) {
    return 1e4;
}

// The faces of a measurement's triangles are looked for at every wavelength (empirical).
double measured_cost(const Job&, const Mechanism&) {
    return 5e4;
}

// The compiler names a mechanism that has no row.
struct TraitsOf {
    MechanismTraits operator()(const Palette&) const { return {.is_closed_form = true, .reference_cost = band_cost}; }
    MechanismTraits operator()(const Film&) const { return {.reference_cost = layered_cost}; }
    MechanismTraits operator()(const Stack&) const { return {.reference_cost = layered_cost}; }
    MechanismTraits operator()(const Grating&) const { return {}; }
    MechanismTraits operator()(const Crystal&) const { return {.has_slices = true, .reference_cost = layered_cost}; }
    MechanismTraits operator()(const Scatter&) const { return {.reference_cost = scattered_cost}; }
    MechanismTraits operator()(const MeasuredSpectra&) const { return {.reference_cost = measured_cost}; }
};

}  // namespace

MechanismTraits traits_of(const Mechanism& mechanism) {
    return std::visit(TraitsOf{}, static_cast<const MechanismModel&>(mechanism));
}

}  // namespace nacre
