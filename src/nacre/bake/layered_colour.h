#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nacre/bake/spectral_sampling.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/multilayer.h"

namespace nacre {

/// The layer systems whose mean is what a film or stack shows: one, or many of an irregular one.
/// @param blurred  nodes that are taken as incoherent
/// @pre needs_sampling(mechanism)
std::vector<LayerSystem> layer_systems(const Mechanism& mechanism, int realisations,
                                       std::span<const std::size_t> blurred = {});

/// The colour of a film or stack, made ready to be asked at many angles.
class LayeredColour {
public:
    /// @pre needs_sampling(mechanism), and the nodes are decided
    LayeredColour(const Mechanism& mechanism, SpectralSampling sampling);

    /// Before adaptation.
    Xyz at(const Incidence& incidence);
    /// Reflectances that the colour at an angle takes.
    std::uint64_t samples(const Incidence& incidence) const;

private:
    SpectralSampling sampling_;
    std::vector<LayerSystem> systems_;
    std::array<std::vector<MultilayerSolver>, band_least_cos_theta.size()> solvers_;  // made when a band is asked for
};

/// What becomes of light at some wavelengths; the mean over realisations of an irregular stack.
std::vector<Response> layered_responses(const Mechanism& mechanism, const Incidence& incidence,
                                        std::span<const double> wavelengths_nm, int realisations);

}  // namespace nacre
