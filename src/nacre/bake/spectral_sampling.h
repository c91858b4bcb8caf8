#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/bake/light.h"
#include "nacre/bake/mechanism.h"
#include "nacre/colour/spectral_nodes.h"

namespace nacre {

struct Job;

/// How the spectra of films and stacks are sampled. Palettes need none of it: their colours are integrals.
struct SpectralSampling {
    std::shared_ptr<const SpectralNodes> nodes;  ///< null: not decided
    int realisations = 1;                        ///< of an irregular stack: layer systems whose mean is taken
    /// Layers that are so thick that eye and light blur their fringes to the last: taken as incoherent. Nodes of the
    /// layer system.
    std::vector<std::size_t> blurred;

    int node_count() const { return nodes ? nodes->count : 0; }
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

/// What was chosen, and the largest CIEDE2000 that it was seen to err by, at the scale of the brightest probe.
struct ChosenSampling {
    SpectralSampling sampling;
    double error = 0.0;
    int spectra = 0;  ///< that choosing took
};

/// The fewest nodes, and realisations, that keep colours within `tolerance` at probes all over the job's axes.
///
/// A layer whose fringes are fine beside everything else in the spectrum is taken as incoherent, if that is seen to
/// change nothing that counts. Then it starts at two nodes per fringe, and goes on until more of them change nothing
/// that counts. The light's own
/// `wavelengths` are taken if the scene insists on them. What the caller has decided already stays.
/// @param node_count,realisations  0: to be chosen
ChosenSampling choose_sampling(const Job& job, double tolerance, int node_count = 0, int realisations = 0);

/// Good for anything that is looked at: CIEDE2000 0.001.
SpectralSampling default_sampling(const Job& job);

/// Enough for what is compared with: finer than any choice, and not much dearer.
SpectralSampling finer_sampling(const Job& job);

}  // namespace nacre
