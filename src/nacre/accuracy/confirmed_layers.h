#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "nacre/optics/layer_system.h"
#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {

/// What layers reflect and transmit at many wavelengths, by the fast solver: its scalar twin has to confirm it at a few
/// wavelengths that a fixed sequence picks. Where it does not, the twin computes everything.
class ConfirmedLayers {
public:
    explicit ConfirmedLayers(LayerEnsemble ensemble);

    /// The mean over the ensemble.
    /// @param wavelengths_nm  each number of them always means the same ones
    std::vector<Response> at(const Incidence& incidence, const std::vector<double>& wavelengths_nm);

    const LayerEnsemble& ensemble() const { return ensemble_; }

    /// So many layers at most the twin walks through.
    static constexpr double most_twin_layers = 40.0;

private:
    bool confirms(const LayerSystem& system, const Incidence& incidence, const std::vector<double>& wavelengths_nm,
                  const std::vector<Response>& responses);
    std::size_t pick(std::size_t count);

    LayerEnsemble ensemble_;
    std::map<std::size_t, std::vector<MultilayerSolver>> solvers_;  // by the number of wavelengths
    std::size_t picks_ = 0;
    bool is_twin_short_;
    bool was_refuted_ = false;
};

}  // namespace nacre
