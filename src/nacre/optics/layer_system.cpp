#include "nacre/optics/layer_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <utility>

namespace nacre {
namespace {

// Layers of nodes [begin, end).
double count_layers(const std::vector<LayerNode>& nodes, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        if (nodes[i].repeat == 0) {
            sum += 1.0;
            continue;
        }
        const std::size_t members = static_cast<std::size_t>(nodes[i].count);
        sum += nodes[i].repeat * count_layers(nodes, i + 1, i + 1 + members);
        i += members;
    }
    return sum;
}

}  // namespace

RefractiveIndex LayerSystem::index_at(int medium, double wavelength_nm) const {
    const Medium& m = media[static_cast<std::size_t>(medium)];
    const RefractiveIndex index = curves[static_cast<std::size_t>(m.curve)].at(wavelength_nm);
    if (m.share == 0.0) return index;
    const RefractiveIndex other = curves[static_cast<std::size_t>(m.other)].at(wavelength_nm);
    if (m.mixing == Mixing::index) return (1.0 - m.share) * index + m.share * other;
    // As neither k is negative, neither is the imaginary part of any n^2: the principal root has k >= 0.
    return std::sqrt((1.0 - m.share) * (index * index) + m.share * (other * other));
}

double expanded_layers(const LayerSystem& system) {
    return count_layers(system.nodes, 0, system.nodes.size());
}

LayerSystemBuilder::LayerSystemBuilder(const Index& incident, const Index& substrate) {
    system_.incident = medium_of({curve_of(incident), 0, 0.0, Mixing::index});
    system_.substrate = medium_of({curve_of(substrate), 0, 0.0, Mixing::index});
}

// The latest are looked at first: neighbours are what repeats.
int LayerSystemBuilder::curve_of(const Index& index) {
    const auto found = std::find(system_.curves.rbegin(), system_.curves.rend(), index);
    if (found != system_.curves.rend()) return static_cast<int>(system_.curves.rend() - found) - 1;
    system_.curves.push_back(index);
    return static_cast<int>(system_.curves.size()) - 1;
}

int LayerSystemBuilder::medium_of(const Medium& medium) {
    // A graded stack may have as many media as layers; who is not among the latest is taken for new.
    constexpr std::ptrdiff_t worth_looking = 64;
    const auto size = static_cast<std::ptrdiff_t>(system_.media.size());
    const auto end = system_.media.rbegin() + std::min(size, worth_looking);
    const auto found = std::find(system_.media.rbegin(), end, medium);
    if (found != end) return static_cast<int>(system_.media.rend() - found) - 1;
    system_.media.push_back(medium);
    return static_cast<int>(size);
}

void LayerSystemBuilder::layer(const Index& index, double thickness_nm, bool is_incoherent) {
    assert(!is_incoherent || open_groups_.empty());
    LayerNode node;
    node.medium = medium_of({curve_of(index), 0, 0.0, Mixing::index});
    node.thickness_nm = thickness_nm;
    node.is_incoherent = is_incoherent;
    system_.nodes.push_back(node);
}

void LayerSystemBuilder::graded_layer(const Index& from, const Index& to, double share, double thickness_nm,
                                      Mixing mixing) {
    if (share == 0.0) return layer(from, thickness_nm);
    if (share == 1.0) return layer(to, thickness_nm);
    LayerNode node;
    node.medium = medium_of({curve_of(from), curve_of(to), share, mixing});
    node.thickness_nm = thickness_nm;
    system_.nodes.push_back(node);
}

void LayerSystemBuilder::begin_group(int repeat) {
    assert(repeat >= 1);
    open_groups_.push_back(system_.nodes.size());
    LayerNode node;
    node.repeat = repeat;
    system_.nodes.push_back(node);
}

void LayerSystemBuilder::end_group() {
    assert(!open_groups_.empty());
    const std::size_t head = open_groups_.back();
    open_groups_.pop_back();
    system_.nodes[head].count = static_cast<int>(system_.nodes.size() - head - 1);
}

LayerSystem LayerSystemBuilder::take() {
    assert(open_groups_.empty());
    return std::move(system_);
}

}  // namespace nacre
