#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nacre/bake/spectral_sampling.h"
#include "nacre/bake/work.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/multilayer.h"

namespace nacre {

/// The layer systems whose mean is what layers show: one, or many of uneven ones. A metal base is part of them, below
/// an incoherent layer of what was the substrate; any other base is not.
/// @param blurred  nodes that are taken as incoherent
/// @pre is_layered(mechanism)
std::vector<LayerSystem> layer_systems(const Mechanism& mechanism, int realisations,
                                       std::span<const std::size_t> blurred = {});

/// Slices per plane of a crystal: more of them change no colour by CIEDE2000 0.001.
inline constexpr int crystal_slices = 24;

/// What a diffuse base sends back of the light that has come through layers: the factor that their transmittance is
/// multiplied by. With rho the base's reflectance, r the layers' reflectance from below and t their transmittance, both
/// for light that comes evenly from all directions:  rho t / (1 - rho r).  Over a white base, layers that take nothing
/// reflect everything.
/// @param points  of the quadrature over directions, on either side of the critical angle
std::vector<double> base_factors(const Base& base, const std::vector<LayerSystem>& systems,
                                 std::span<const double> wavelengths_nm, int points, Work* work = nullptr);

/// The colour of a film, stack or crystal, made ready to be asked at many angles.
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
        std::vector<MultilayerSolver> solvers;  // one per system; none: not asked for yet
        std::vector<double> base_factors;       // per node; none: no diffuse base
    };
    Band& band_at(std::size_t index, Work* work);
    Xyz with_base(const Band& band, const SpectralNodes& nodes, const Incidence& incidence) const;
    void count(const SpectralNodes& nodes, Work& work) const;

    SpectralSampling sampling_;
    Effects effects_;
    std::vector<LayerSystem> systems_;
    std::array<Band, band_least_cos_theta.size()> bands_;
};

/// What becomes of light at some wavelengths, for many angles; the mean over realisations of uneven layers. Nothing
/// passes a base.
class LayeredSpectra {
public:
    /// @pre is_layered(mechanism)
    LayeredSpectra(const Mechanism& mechanism, std::span<const double> wavelengths_nm, int realisations);

    std::vector<Response> at(const Incidence& incidence) const;

private:
    std::size_t count_;
    std::vector<MultilayerSolver> solvers_;  // one per realisation
    std::vector<double> base_factors_;       // none: no diffuse base
};

}  // namespace nacre
