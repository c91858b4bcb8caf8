// The parts of yaml_tree.h that need no yaml-cpp.
#include <algorithm>
#include <cstddef>

#include "io/scene/yaml_tree.h"

namespace nacre {

const YamlNode* YamlNode::find(std::string_view key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

std::string printable(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    return result;
}

}  // namespace nacre
