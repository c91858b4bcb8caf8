#include "nacre/scene/readers/pick_reader.h"

#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/hex_colour.h"

namespace nacre {

std::optional<Rgb> parse_hex_colour(const std::string& text) {
    if (text.size() != 4 && text.size() != 7) return {};
    if (text.front() != '#') return {};
    std::vector<int> digits;
    for (const char character : text.substr(1)) {
        const auto byte = static_cast<unsigned char>(character);
        if (std::isxdigit(byte) == 0) return {};
        digits.push_back(std::isdigit(byte) != 0 ? character - '0' : std::tolower(byte) - 'a' + 10);
    }
    const auto component = [&](std::size_t i) {
        return digits.size() == 3 ? digits[i] / 15.0 : (16 * digits[2 * i] + digits[2 * i + 1]) / 255.0;
    };
    return Rgb{component(0), component(1), component(2)};
}

namespace {

// What a half holds.
constexpr Allowed allowed_component{-65504.0, 65504.0};

Rgb read_components(const Table& pick, const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        if (const auto colour = parse_hex_colour(*text)) return *colour;
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

std::string written(const Value& value, const Rgb& colour) {
    if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
    return "[" + number_text(colour.r) + ", " + number_text(colour.g) + ", " + number_text(colour.b) + "]";
}

}  // namespace

std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read) {
    const Value* value = pick.find("colour");
    if (value == nullptr) {
        if (const Value* space = pick.find("space"))
            pick.fail(space->where, "space belongs to a colour, and the pick has none; give colour = [r, g, b]");
        return {};
    }
    const Rgb components = read_components(pick, *value);
    const std::string space = pick.text_or("space", "");
    for (const char* number : {"peak_nm", "width_nm", "height"}) {
        if (const Value* other = pick.find(number)) {
            pick.fail(other->where, std::string(number) + " and colour both say what is seen; remove one of them");
        }
    }
    PickedColour picked;
    picked.text = written(*value, components) + (space.empty() ? "" : " in " + space);
    picked.where = value->where;
    picked.colour = read(components, space, value->where);
    return picked;
}

void find_band(const PickReaders& readers, PickedColour& picked) {
    picked.lobe = readers.find_lobe(picked.colour);
    picked.de00 = picked.lobe->de00;
    picked.reached = readers.lobe_colour({picked.lobe->peak_nm, picked.lobe->width_nm, picked.lobe->height});
}

}  // namespace nacre
