#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// The colour of a scattering layer, prepared for evaluation at many angles.
class ScatterColour {
public:
    /// @pre the mechanism is scatter, and the nodes are decided
    ScatterColour(const Mechanism& mechanism, const SpectralSampling& sampling);

    /// Before adaptation. @param work  what it takes is added
    Xyz at(double cos_scatter, Work* work = nullptr) const;
    /// Spheres, wavelengths and terms of their series that a colour takes, in all.
    std::uint64_t samples() const { return samples_; }

private:
    std::shared_ptr<const SpectralNodes> nodes_;
    std::shared_ptr<const ScatterSolver> solver_;
    Polarisation polarisation_;
    bool is_spread_;
    bool absorbs_;
    bool is_dispersive_;
    std::uint64_t samples_;
};

}  // namespace nacre
