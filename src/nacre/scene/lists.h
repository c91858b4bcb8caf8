#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// A name that a scene may use, and half a line about it.
struct ListedName {
    std::string name;
    std::string description;
};

/// One list of names.
struct NameList {
    std::string_view name;         ///< "mechanisms"
    std::string_view description;  ///< "what may make a material's colour"
    std::string_view where;        ///< the key that takes the names: "mechanism of [material.NAME]"
    std::vector<ListedName> (*names)();
};

/// Everything that the core itself can list: mechanisms, effects, axes, illuminants, observers, adaptations, gamuts,
/// formats, outputs, swatches. The first name of a list is its default, where it has one. Materials, colour spaces and
/// displays are listed by io.
std::span<const NameList> name_lists();

}  // namespace nacre
