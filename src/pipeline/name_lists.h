#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/lut/colour_spaces.h"
#include "nacre/scene/lists.h"

namespace nacre {

/// A list of names that a scene may use.
struct ListTitle {
    std::string name;         ///< "materials"
    std::string description;  ///< "shipped materials"
    std::string where;        ///< the key that takes the names
};

/// All lists: those of the core, then `materials`, `metals`, `spaces` and `displays`.
std::vector<ListTitle> list_titles();

/// The names of one of them. The config is opened for `spaces` and `displays` only.
/// @throws Error for an unknown list, or a config that cannot be read
std::vector<ListedName> listed_names(std::string_view list, const OpenColourSpaces& open_colours,
                                     const ColourConfigChoice& config);

}  // namespace nacre
