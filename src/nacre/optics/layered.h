#pragma once

#include <optional>
#include <vector>

#include "nacre/optics/layer_system.h"
#include "nacre/optics/refractive_index.h"

namespace nacre {

/// One layer as a scene describes it, or a group of layers that repeats.
struct Layer {
    Index index;
    double thickness_nm = 0.0;
    bool is_incoherent = false;
    /// Graded periods: what the last repeat of the innermost group has; index and thickness_nm are the first one's, and
    /// those between lie on a straight line.
    std::optional<Index> last_index;
    std::optional<double> last_thickness_nm;

    int repeat = 0;             ///< 0: a layer. Else a group, >= 1
    std::vector<Layer> layers;  ///< of a group

    friend bool operator==(const Layer&, const Layer&) = default;
};

/// One film on a substrate, or free in the medium that light comes from.
struct Film {
    Index incident;
    Index index;
    double thickness_nm = 0.0;
    Index substrate;
    double thickness_spread_nm = 0.0;  ///< as of Stack
    friend bool operator==(const Film&, const Film&) = default;
};

/// Any sequence of layers.
struct Stack {
    Index incident;
    std::vector<Layer> layers;  ///< in the order in which light meets them
    Index substrate;
    /// Standard deviation of the thickness of every layer, each on its own, over the area that is seen at once; 0: a
    /// perfect stack. Incoherent layers have none.
    double thickness_spread_nm = 0.0;
    friend bool operator==(const Stack&, const Stack&) = default;
};

/// What the solvers take. Groups with graded layers are written out.
LayerSystem layer_system(const Film& film);
LayerSystem layer_system(const Stack& stack);

/// Layers after all repeats, in double, so that no repeat overflows.
double expanded_layers(const std::vector<Layer>& layers);

}  // namespace nacre
