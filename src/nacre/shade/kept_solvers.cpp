#include "nacre/shade/kept_solvers.h"

#include <algorithm>
#include <utility>

#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

// Chosen: a step of the choice goes to and fro between so many; a few megabytes at most.
constexpr std::size_t most_kept = 8;
constexpr std::size_t most_wavelengths = 1 << 14;

template <typename Entry>
void keep(std::vector<Entry>& entries, Entry entry) {
    if (entries.size() >= most_kept) entries.erase(entries.begin());
    entries.push_back(std::move(entry));
}

Solvers make_layers(const std::vector<LayerSystem>& systems, const Nodes& nodes) {
    std::vector<MultilayerSolver> solvers;
    solvers.reserve(systems.size());
    for (const LayerSystem& system : systems) solvers.emplace_back(system, nodes->wavelength_nm);
    return std::make_shared<const std::vector<MultilayerSolver>>(std::move(solvers));
}

std::shared_ptr<const ScatterSolver> make_scatter(const Scatter& scatter, const Nodes& nodes, int sizes) {
    return std::make_shared<const ScatterSolver>(scatter, nodes->wavelength_nm, sizes);
}

}  // namespace

Solvers KeptSolvers::layers(const std::vector<LayerSystem>& systems, const Nodes& nodes) {
    const auto found = std::find_if(layers_.begin(), layers_.end(), [&](const OfLayers& entry) {
        return entry.nodes == nodes && entry.systems == systems;
    });
    if (found != layers_.end()) return found->solvers;
    Solvers made = make_layers(systems, nodes);
    if (systems.size() * nodes->wavelength_nm.size() <= most_wavelengths) keep(layers_, OfLayers{systems, nodes, made});
    return made;
}

std::shared_ptr<const ScatterSolver> KeptSolvers::scatter(const Scatter& scatter, const Nodes& nodes, int sizes) {
    const auto found = std::find_if(scatter_.begin(), scatter_.end(), [&](const OfScatter& entry) {
        return entry.nodes == nodes && entry.sizes == sizes && entry.scatter == scatter;
    });
    if (found != scatter_.end()) return found->solver;
    std::shared_ptr<const ScatterSolver> made = make_scatter(scatter, nodes, sizes);
    if (static_cast<std::size_t>(sizes) * nodes->wavelength_nm.size() <= most_wavelengths)
        keep(scatter_, OfScatter{scatter, nodes, sizes, made});
    return made;
}

std::vector<double> KeptSolvers::base_factors(const Base& base, const LayerEnsemble& layers, const Nodes& nodes,
                                              int points, Work* work) {
    auto found = std::find_if(bases_.begin(), bases_.end(), [&](const OfBase& entry) {
        return entry.nodes == nodes && entry.points == points && entry.base == base && entry.layers == layers;
    });
    if (found == bases_.end()) {
        Work taken;
        std::vector<double> factors = nacre::base_factors(base, layers, nodes->wavelength_nm, points, &taken);
        keep(bases_, OfBase{base, layers, nodes, points, std::move(factors), taken});
        found = bases_.end() - 1;
    }
    if (work != nullptr) *work += found->work;
    return found->factors;
}

Solvers layer_solvers(KeptSolvers* kept, const std::vector<LayerSystem>& systems, const Nodes& nodes) {
    return kept != nullptr ? kept->layers(systems, nodes) : make_layers(systems, nodes);
}

std::shared_ptr<const ScatterSolver> scatter_solver(KeptSolvers* kept, const Scatter& scatter, const Nodes& nodes,
                                                    int sizes) {
    return kept != nullptr ? kept->scatter(scatter, nodes, sizes) : make_scatter(scatter, nodes, sizes);
}

}  // namespace nacre
