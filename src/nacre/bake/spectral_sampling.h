#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nacre/bake/light.h"
#include "nacre/bake/mechanism.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/optics/incidence.h"

namespace nacre {

struct Job;

/// Angles in bands, by their cosine: towards grazing every face is a mirror, fringes become sharp, and a spectrum wants
/// more nodes.
inline constexpr std::array<double, 4> band_least_cos_theta{0.3, 0.05, 0.004, 0.0};
using NodeCounts = std::array<int, band_least_cos_theta.size()>;
std::size_t band_of(const Incidence& incidence);

/// How the spectra of films and stacks are sampled. Palettes need none of it: their colours are integrals.
struct SpectralSampling {
    std::array<std::shared_ptr<const SpectralNodes>, band_least_cos_theta.size()> nodes;  ///< null: not decided
    int realisations = 1;  ///< of an irregular stack: layer systems whose mean is taken
    /// Layers that are so thick that eye and light blur their fringes to the last: taken as incoherent. Nodes of the
    /// layer system.
    std::vector<std::size_t> blurred;

    bool is_decided() const { return nodes.front() != nullptr; }
    /// 0 in all bands if not decided.
    NodeCounts node_counts() const;
};

/// Whether a mechanism is sampled at nodes at all.
bool needs_sampling(const Mechanism& mechanism);
/// Whether it is a mean over realisations.
bool is_irregular(const Mechanism& mechanism);

/// Interference fringes that the mechanism shows over the light's range, were all its layers one: twice the optical
/// path times the range of wavenumbers. 0 for a palette. Incoherent layers do not count.
double fringe_count(const Mechanism& mechanism, const LightSettings& light);

/// Beyond this no grid of ours resolves them: a coherent slab of some 7 mm of glass.
inline constexpr double most_fringes = 32768.0;
inline constexpr int most_nodes = 1 << 17;

/// What was chosen, and what it was seen to err by, CIEDE2000 at the scale of the brightest probe.
struct ChosenSampling {
    SpectralSampling sampling;
    double error = 0.0;         ///< of the nodes
    double spread_error = 0.0;  ///< of how many realisations an irregular stack has
    int spectra = 0;            ///< that choosing took
};

/// What a caller insists on; 0: to be chosen.
struct SamplingWish {
    NodeCounts nodes{};
    int realisations = 0;
};

/// The fewest nodes that keep colours within `tolerance` at probes all over the job's axes (twice and three times that
/// in the two bands next to grazing; between probes they may err by half as much again), and the fewest realisations of
/// an irregular stack that keep them within `spread_tolerance`, or `most_chosen_realisations`.
///
/// A layer whose fringes are fine beside everything else in the spectrum is taken as incoherent, if that is seen to
/// change nothing that counts. Then it starts at two nodes per fringe, and goes on until more of them change nothing
/// that counts. The light's own `wavelengths` are taken if the scene insists on them.
/// Thousands of layers may want more than a search should take: then it ends with what it has, and tells its error.
/// @param after_step  called every few colours; what it throws ends the choice
ChosenSampling choose_sampling(const Job& job, double tolerance, double spread_tolerance, const SamplingWish& wish = {},
                               const std::function<void()>& after_step = {});

inline constexpr int most_chosen_realisations = 512;

/// Good for anything that is looked at: CIEDE2000 0.001, and 0.1 for the mean of an irregular stack.
SpectralSampling default_sampling(const Job& job);

}  // namespace nacre
