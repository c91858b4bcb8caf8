#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/layer_system.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/kept_solvers.h"
#include "nacre/shade/work.h"

namespace nacre {

/// Angles in bands, by their cosine: towards grazing every face is a mirror, fringes become narrow, and a spectrum
/// needs more nodes. Scattering uses the first band only.
inline constexpr std::array<double, 4> band_least_cos_theta{0.3, 0.05, 0.004, 0.0};
using NodeCounts = std::array<int, band_least_cos_theta.size()>;
std::size_t band_of(const Incidence& incidence);

/// How many points each sum of a colour takes. In a request 0 leaves a number to be chosen.
struct SamplingCounts {
    NodeCounts nodes{};         ///< wavelengths at which spectra are sampled, per band of angles
    int thickness_samples = 0;  ///< layer systems whose mean is what uneven layers show
    int base_directions = 0;    ///< of light below layers with a base, on either side of the critical angle
    int radii = 0;              ///< of scattering spheres
    int slices = 0;             ///< of a crystal's plane, in each of which its index is even
    friend bool operator==(const SamplingCounts&, const SamplingCounts&) = default;
};

inline constexpr int default_slices = 24;

/// The sampling of colours that have no closed form: the nodes of spectra, and the points of effects that are
/// integrals.
struct SpectralSampling {
    std::array<std::shared_ptr<const SpectralNodes>, band_least_cos_theta.size()> nodes;  ///< null: not decided
    int thickness_samples = 1;                                                            ///< see SamplingCounts
    int base_directions = 8;                                                              ///< likewise
    int radii = 1;                                                                        ///< likewise
    int slices = default_slices;                                                          ///< likewise
    /// Layers so thick that their fringes cannot be seen; they are computed as incoherent. Nodes of the layer system.
    std::vector<std::size_t> incoherent_layers;
    /// Of a tilted surface: what one facet shows, before adaptation, with what its mean takes most time for; null: made
    /// when it is asked for.
    std::shared_ptr<const FacetColours> facets;
    /// What was prepared for other colours, while a LUT is chosen or measured; null: nothing is kept.
    std::shared_ptr<KeptSolvers> kept;

    bool is_decided() const { return nodes.front() != nullptr; }
    /// The nodes are 0 in all bands if not decided.
    SamplingCounts counts() const;
};

/// Whether a mechanism's spectra are sampled at nodes: only then does a SpectralSampling have anything to choose.
bool samples_spectra(const Mechanism& mechanism);
/// Whether it is a mean over samples of uneven thicknesses.
bool is_irregular(const Mechanism& mechanism);

/// Interference fringes over the light's range, were all coherent layers one.
double fringe_count(const LayerSystem& system, const LightSettings& light);

/// Interference fringes that the mechanism shows over the light's range, were all its layers one: twice the optical
/// path times the range of wavenumbers. 0 for what is not made of layers. Incoherent layers do not count.
double fringe_count(const Mechanism& mechanism, const LightSettings& light);

/// Intervals of a right angle in which the reflectance of a facet is a polynomial of low degree; see FacetPoints.
int facet_intervals(const Mechanism& mechanism);

/// The cost of a reflectance at one wavelength, in units of that of a film.
/// @param slices  per plane of a crystal
double effort_per_sample(const Mechanism& mechanism, int slices = default_slices);

/// The largest number that the grids resolve: a coherent slab of about 7 mm of glass.
inline constexpr double most_fringes = 32768.0;
inline constexpr int most_nodes = 1 << 17;

}  // namespace nacre
