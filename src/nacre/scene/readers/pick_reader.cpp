// A pick: a colour, or a band of reflectance, that a material has at an angle.
#include "nacre/scene/readers/pick_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/hex_colour.h"

namespace nacre {
namespace {

// What a half holds.
constexpr Allowed allowed_component{-65504.0, 65504.0};
// Chosen: more picks than anybody makes by hand. All pairs of them are compared.
constexpr std::size_t most_picks = 100;

Rgb read_components(const Table& pick, const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        if (const auto colour = parse_hex_colour(*text)) return *colour;
        if (const std::string opaque = without_alpha(*text); !opaque.empty()) {
            pick.fail(value.where, "colour = " + in_quotes(*text) +
                                       " has an alpha component, and a reflectance has none; give " +
                                       in_quotes(opaque));
        }
        pick.fail(value.where,
                  "colour = " + in_quotes(*text) + " is not a colour; give \"#rrggbb\", \"#rgb\" or [r, g, b]");
    }
    const Value::Array& list = pick.checked_array("colour", value);
    if (list.size() != 3) {
        pick.fail(value.where, "colour has " + std::to_string(list.size()) +
                                   (list.size() == 1 ? " component" : " components") + "; give 3: [r, g, b]");
    }
    std::array<double, 3> components{};
    for (std::size_t i = 0; i < 3; ++i) components[i] = pick.checked_number("colour", list[i], allowed_component);
    return {components[0], components[1], components[2]};
}

// Whole numbers up to 255, one of which is no 0 or 1.
bool look_like_bytes(const Rgb& colour) {
    const std::array components{colour.r, colour.g, colour.b};
    const auto is_byte = [](double c) { return c >= 0.0 && c <= 255.0 && c == std::floor(c); };
    return std::all_of(components.begin(), components.end(), is_byte) &&
           *std::max_element(components.begin(), components.end()) > 1.0;
}

std::string written(const Value& value, const Rgb& colour) {
    if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
    return "[" + number_text(colour.r) + ", " + number_text(colour.g) + ", " + number_text(colour.b) + "]";
}

}  // namespace

const Value::Array& read_pick_list(const Table& table, const Value& picks) {
    const Value::Array& list = table.checked_array("picks", picks);
    if (list.empty() || list.size() > most_picks) {
        table.fail(picks.where,
                   "picks has " + std::to_string(list.size()) + " entries; allowed 1 to " + std::to_string(most_picks));
    }
    return list;
}

Lobe read_lobe(const Table& pick) {
    Lobe lobe;
    const auto is_given = [&](const LobeKey& key) { return pick.find(key.key) != nullptr; };
    if (std::count_if(lobe_keys.begin(), lobe_keys.end(), is_given) == 0) {
        pick.note_missing("colour", "give \"#rrggbb\", [r, g, b], or a band: peak_nm, width_nm, height");
        return lobe;
    }
    for (const LobeKey& key : lobe_keys) {
        lobe.*key.member =
            key.may_be_left_out ? pick.number_or(key.key, key.allowed, 0.0) : pick.number(key.key, key.allowed);
    }
    return lobe;
}

std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read) {
    const Value* value = pick.find("colour");
    if (value == nullptr) {
        if (const Value* space = pick.find("space"))
            pick.fail(space->where, "space belongs to a colour, and the pick has none; give colour = [r, g, b]");
        return {};
    }
    const Rgb components = read_components(pick, *value);
    const std::string space = pick.text_or("space", "");
    for (const LobeKey& key : lobe_keys) {
        if (const Value* other = pick.find(key.key)) {
            pick.fail(other->where, std::string(key.key) + " and colour both say what is seen; remove one of them");
        }
    }
    PickedColour picked;
    picked.text = written(*value, components) + (space.empty() ? "" : " in " + space);
    picked.where = value->where;
    picked.colour = read(components, space, value->where);
    picked.looks_like_bytes = look_like_bytes(components);
    return picked;
}

}  // namespace nacre
