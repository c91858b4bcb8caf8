#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/irregular.h"
#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// The layer system without random thicknesses. A metal base is part of it, below an incoherent layer of what was the
/// substrate; any other base is not.
/// @param incoherent  nodes that are taken as incoherent
/// @param slices   per plane of a crystal
/// @pre is_layered(mechanism)
LayerSystem even_system(const Mechanism& mechanism, std::span<const std::size_t> incoherent = {},
                        int slices = default_slices);

/// The layer systems whose mean is the colour of the layers: one without random thicknesses, or many samples of them. A
/// crystal's domains are regular, each with its own spacing.
/// @param samples  at most so many systems
/// @pre is_layered(mechanism)
LayerEnsemble layer_ensemble(const Mechanism& mechanism, int samples, std::span<const std::size_t> incoherent = {},
                             int slices = default_slices);

/// How many samples are worth trying for an uneven mechanism. @pre is_layered(mechanism)
ThicknessSampleCounts thickness_sample_counts(const Mechanism& mechanism);

/// The factor by which the transmittance of the layers is multiplied to give the light that a diffuse base sends back
/// through them. With rho the base's reflectance, r the layers' reflectance from below and t their transmittance, both
/// for light that comes evenly from all directions:  rho t / (1 - rho r).  Over a white base, layers that absorb
/// nothing reflect everything.
/// @param points  of the quadrature over directions, on either side of the critical angle
std::vector<double> base_factors(const Base& base, const LayerEnsemble& ensemble,
                                 std::span<const double> wavelengths_nm, int points, Work* work = nullptr);

/// The colour of a film, stack or crystal, prepared for evaluation at many angles.
class LayeredColour {
public:
    /// @pre is_layered(mechanism), and the nodes are decided
    LayeredColour(const Mechanism& mechanism, SpectralSampling sampling);

    /// Before adaptation. @param work  what it takes is added
    Xyz at(const Incidence& incidence, Work* work = nullptr);
    /// Reflectances that the colour at an angle takes.
    std::uint64_t samples(const Incidence& incidence) const;

private:
    struct Band {
        Solvers solvers;                   // one per system; null: not asked for yet
        std::vector<double> base_factors;  // per node; none: no diffuse base
    };
    Band& band_at(std::size_t index, Work* work);
    Xyz with_base(const Band& band, const SpectralNodes& nodes, const Incidence& incidence) const;
    void count(const SpectralNodes& nodes, Work& work) const;

    SpectralSampling sampling_;
    Effects effects_;
    LayerEnsemble ensemble_;
    std::array<Band, band_least_cos_theta.size()> bands_;
};

/// Per plane of a crystal, wherever single reflectances are asked for.
inline constexpr int spectrum_slices = 96;

/// Reflectance and transmittance at some wavelengths, for many angles; the mean over samples of random thicknesses. A
/// base transmits nothing.
class LayeredSpectra {
public:
    /// @pre is_layered(mechanism)
    LayeredSpectra(const Mechanism& mechanism, std::span<const double> wavelengths_nm, int samples);

    std::vector<Response> at(const Incidence& incidence) const;

private:
    std::size_t count_;
    std::vector<double> shares_;             // of each solver
    std::vector<MultilayerSolver> solvers_;  // one per sample
    std::vector<double> base_factors_;       // none: no diffuse base
};

}  // namespace nacre
