#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/colour/xyz_curve.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/shade/work.h"

namespace nacre {

struct Job;

/// Angles in bands, by their cosine: towards grazing every face is a mirror, fringes become sharp, and a spectrum wants
/// more nodes. Scattering knows the first band only.
inline constexpr std::array<double, 4> band_least_cos_theta{0.3, 0.05, 0.004, 0.0};
using NodeCounts = std::array<int, band_least_cos_theta.size()>;
std::size_t band_of(const Incidence& incidence);

/// How colours that are no closed form are computed: where spectra are sampled, and how effects that are integrals are.
inline constexpr int default_slices = 24;

struct SpectralSampling {
    std::array<std::shared_ptr<const SpectralNodes>, band_least_cos_theta.size()> nodes;  ///< null: not decided
    int realisations = 1;  ///< of uneven layers: layer systems whose mean is taken
    /// Layers that are so thick that eye and light blur their fringes to the last: taken as incoherent. Nodes of the
    /// layer system.
    std::vector<std::size_t> blurred;
    /// Of a tilted surface: what one facet shows, before adaptation; null: made when it is asked for.
    std::shared_ptr<const XyzCurve> facets;
    int hemisphere = 8;  ///< directions of light below layers with a base, on either side of the critical angle
    int sizes = 1;       ///< radii of spheres
    int slices = default_slices;  ///< of a crystal's period, in each of which its index is even

    bool is_decided() const { return nodes.front() != nullptr; }
    /// 0 in all bands if not decided.
    NodeCounts node_counts() const;
};

/// Numbers of points that a scene insists on; 0: to be chosen.
struct QuadratureWish {
    int hemisphere = 0;
    int sizes = 0;
    int slices = 0;
};

/// Whether a mechanism's spectra are sampled at nodes: only then is there anything of a SpectralSampling to decide.
bool samples_spectra(const Mechanism& mechanism);
/// Whether it is a mean over realisations.
bool is_irregular(const Mechanism& mechanism);

/// Interference fringes that the mechanism shows over the light's range, were all its layers one: twice the optical
/// path times the range of wavenumbers. 0 for what is not made of layers. Incoherent layers do not count.
double fringe_count(const Mechanism& mechanism, const LightSettings& light);

/// What a reflectance at one wavelength takes, in units of a film's.
/// @param slices  per plane of a crystal
double effort_per_sample(const Mechanism& mechanism, int slices = default_slices);

/// Beyond this no grid of ours resolves them: a coherent slab of some 7 mm of glass.
inline constexpr double most_fringes = 32768.0;
inline constexpr int most_nodes = 1 << 17;

/// What was found out about an effect that the material has.
struct EffectChoice {
    Effect effect = Effect::dispersion;
    bool is_simulated = true;
    bool is_given = false;      ///< whether the scene says to do without
    bool is_measured = false;   ///< whether anybody looked
    double contribution = 0.0;  ///< what leaving it out changes, CIEDE2000 at the scale of the brightest probe
    double share = 0.0;         ///< of the budget, up to which it is left out
    friend bool operator==(const EffectChoice&, const EffectChoice&) = default;
};

/// What was chosen, and what it was seen to err by, CIEDE2000 at the scale of the brightest probe.
struct ChosenSampling {
    SpectralSampling sampling;
    std::vector<EffectChoice> effects;  ///< of the material, in the enumeration's order
    EffectSet without;                  ///< of these, what is left out
    double error = 0.0;                 ///< of the nodes
    double spread_error = 0.0;          ///< of how many realisations uneven layers have
    double quadrature_error = 0.0;      ///< of base, radii and slices together
    double effects_error = 0.0;         ///< of what is left out, together
    Work work;                          ///< that choosing took
};

/// What a choice may err by, CIEDE2000.
struct SamplingTolerance {
    double nodes = 1e-3;
    double spread = 0.1;
    double quadrature = 1e-3;  ///< each
    double effects = 0.0;      ///< of all that are left out; 0: none is
};

/// What a caller insists on; 0: to be chosen.
struct SamplingWish {
    NodeCounts nodes{};
    int realisations = 0;
    QuadratureWish points;
};

/// The fewest nodes that keep colours within the tolerance at probes all over the job's axes (twice and three times
/// that in the two bands next to grazing; between probes they may err by half as much again), and likewise the fewest
/// points of every other sum.
///
/// First a layer whose fringes are fine beside everything else in the spectrum is taken as incoherent, if that is seen
/// to change nothing that counts. Nodes start at two per fringe, and grow until more of them change nothing that
/// counts. Then every effect is left out for once: whatever changes no probe by more than its part of `effects` is left
/// out for good. Then come realisations, radii and directions below a base. The light's own `wavelengths` are
/// taken if the scene insists on them; job.without is left out, and what that changes is an error like any other.
/// Thousands of layers may want more than a search should take: then it ends with what it has, and tells its error.
/// @param after_step  called every few colours; what it throws ends the choice
ChosenSampling choose_sampling(const Job& job, const SamplingTolerance& tolerance, const SamplingWish& wish = {},
                               const std::function<void()>& after_step = {});

/// Good for anything that is looked at: CIEDE2000 0.001, and 0.1 for the mean of uneven layers; every effect.
SpectralSampling default_sampling(const Job& job);

}  // namespace nacre
