#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/colour/spectral_nodes.h"
#include "nacre/optics/base.h"
#include "nacre/optics/layer_system.h"
#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/optics/scatter.h"
#include "nacre/shade/work.h"

namespace nacre {

using Solvers = std::shared_ptr<const std::vector<MultilayerSolver>>;
using Nodes = std::shared_ptr<const SpectralNodes>;

/// What was prepared for a material at some nodes, for all who ask for the same again: whoever chooses a LUT probes one
/// material many times. Not to be used by two threads at once.
class KeptSolvers {
public:
    /// One per system.
    Solvers layers(const std::vector<LayerSystem>& systems, const Nodes& nodes);
    std::shared_ptr<const ScatterSolver> scatter(const Scatter& scatter, const Nodes& nodes, int sizes);
    /// As nacre::base_factors(). @param work  is added to as if nothing were kept; null: nobody asks
    std::vector<double> base_factors(const Base& base, const LayerEnsemble& layers, const Nodes& nodes, int points,
                                     Work* work);

private:
    struct OfBase {
        Base base;
        LayerEnsemble layers;
        Nodes nodes;
        int points;
        std::vector<double> factors;
        Work work;
    };
    struct OfLayers {
        std::vector<LayerSystem> systems;
        Nodes nodes;
        Solvers solvers;
    };
    struct OfScatter {
        Scatter scatter;
        Nodes nodes;
        int sizes;
        std::shared_ptr<const ScatterSolver> solver;
    };
    std::vector<OfLayers> layers_;  // the last one last
    std::vector<OfScatter> scatter_;
    std::vector<OfBase> bases_;
};

/// The same without keeping anything where there is no `kept`.
Solvers layer_solvers(KeptSolvers* kept, const std::vector<LayerSystem>& systems, const Nodes& nodes);
std::shared_ptr<const ScatterSolver> scatter_solver(KeptSolvers* kept, const Scatter& scatter, const Nodes& nodes,
                                                    int sizes);

}  // namespace nacre
