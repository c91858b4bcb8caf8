#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "nacre/material/mechanism.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Three numbers of linear Rec.709. Throws if they are more or fewer. @pre the table has the key
std::array<double, 3> read_rec709(const Table& table, std::string_view key, const Allowed& allowed);

/// { f0, edge_tint }: the colour of a metal; nothing if the table has neither key. Throws for mistakes, and where no
/// metal lies.
/// @param key  what the table stands behind
std::optional<MetalColour> read_metal(const Table& table, std::string_view key);

/// `prefix` + "f0", the largest component of f0: the others keep their proportions to it.
Parameter f0_parameter(const std::string& prefix, const std::string& of_what, const MetalColour& colour,
                       const std::function<Index&(Mechanism&)>& find);

}  // namespace nacre
