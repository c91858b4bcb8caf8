#include "nacre/optics/reversed.h"

#include <cstddef>
#include <vector>

namespace nacre {
namespace {

// The siblings in [begin, end), the last first, each group before its members.
void append_reversed(const std::vector<LayerNode>& nodes, std::size_t begin, std::size_t end,
                     std::vector<LayerNode>& out) {
    std::vector<std::size_t> siblings;
    for (std::size_t i = begin; i < end; i += 1 + static_cast<std::size_t>(nodes[i].count)) siblings.push_back(i);
    for (auto sibling = siblings.rbegin(); sibling != siblings.rend(); ++sibling) {
        out.push_back(nodes[*sibling]);
        append_reversed(nodes, *sibling + 1, *sibling + 1 + static_cast<std::size_t>(nodes[*sibling].count), out);
    }
}

}  // namespace

LayerSystem reversed(const LayerSystem& system) {
    LayerSystem result = system;
    result.incident = system.substrate;
    result.substrate = system.incident;
    result.nodes.clear();
    append_reversed(system.nodes, 0, system.nodes.size(), result.nodes);
    return result;
}

}  // namespace nacre
