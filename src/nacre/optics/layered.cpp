#include "nacre/optics/layered.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

bool is_graded(const Layer& layer) {
    return layer.last_index || layer.last_thickness_nm;
}

// @param share  how far the innermost group has got: 0 at its first repeat, 1 at its last
void add_layers(const std::vector<Layer>& layers, double share, LayerSystemBuilder& builder);

void add_group(const Layer& group, LayerSystemBuilder& builder) {
    if (std::none_of(group.layers.begin(), group.layers.end(), is_graded)) {
        builder.begin_group(group.repeat);
        add_layers(group.layers, 0.0, builder);
        builder.end_group();
        return;
    }
    for (int time = 0; time < group.repeat; ++time)
        add_layers(group.layers, group.repeat == 1 ? 0.0 : static_cast<double>(time) / (group.repeat - 1), builder);
}

void add_layers(const std::vector<Layer>& layers, double share, LayerSystemBuilder& builder) {
    for (const Layer& layer : layers) {
        if (layer.repeat > 0) {
            add_group(layer, builder);
            continue;
        }
        const double thickness_nm =
            std::lerp(layer.thickness_nm, layer.last_thickness_nm.value_or(layer.thickness_nm), share);
        if (layer.last_index) {
            builder.graded_layer(layer.index, *layer.last_index, share, thickness_nm);
        } else {
            builder.layer(layer.index, thickness_nm, layer.is_incoherent);
        }
    }
}

}  // namespace

LayerSystem layer_system(const Film& film) {
    LayerSystemBuilder builder(film.incident, film.substrate);
    builder.layer(film.index, film.thickness_nm);
    return builder.take();
}

LayerSystem layer_system(const Stack& stack) {
    LayerSystemBuilder builder(stack.incident, stack.substrate);
    add_layers(stack.layers, 0.0, builder);
    return builder.take();
}

double expanded_layers(const std::vector<Layer>& layers) {
    double sum = 0.0;
    for (const Layer& layer : layers) sum += layer.repeat > 0 ? layer.repeat * expanded_layers(layer.layers) : 1.0;
    return sum;
}

}  // namespace nacre
