#include "nacre/pick/picked_colour.h"

#include <algorithm>
#include <array>
#include <cctype>

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
        pick.fail(value.where, "colour = " + in_quotes(*text) + " is none; give \"#rrggbb\", \"#rgb\" or [r, g, b]");
    }
    const Value::Array& list = pick.checked_array("colour", value);
    if (list.size() != 3) {
        pick.fail(value.where, "colour has " + std::to_string(list.size()) +
                                   (list.size() == 1 ? " component" : " components") + "; allowed are 3: [r, g, b]");
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

bool PickedColour::is_met() const {
    return lobe ? lobe->miss == LobeMiss::none : de00 <= met_de00;
}

namespace {

constexpr double all_light = 1.0001;  // as Y, and rounding

// Why no structure shows a colour, where physics says so at once.
std::string reason(const PickedColour& picked) {
    constexpr double grazing_deg = 89.99;
    if (picked.mechanism == "grating") {
        if (picked.angle_deg == 0.0)
            return "nothing but the mirror's order 0 comes straight back, and that does not count";
    } else if (picked.angle_deg >= grazing_deg) {
        return "at 90 degrees every face reflects all light: it is white";
    } else if (picked.colour.y > all_light) {
        return "nothing reflects more than all light";
    }
    return "no " + picked.mechanism + " was found that comes nearer, all picks together";
}

}  // namespace

std::string match_text(const PickedColour& picked) {
    std::string away = "CIEDE2000 " + significant_text(picked.de00, 3) + " away";
    if (!picked.lobe) {
        if (picked.is_met()) return "met, CIEDE2000 " + significant_text(picked.de00, 2);
        if (!picked.is_searched) return away;
        return away + ", because " + reason(picked);
    }
    if (picked.lobe->miss != LobeMiss::none) {
        if (picked.colour.y < 0.0) return away + ", because it is darker than black";
        if (picked.colour.y > all_light) return away + ", because nothing reflects more than all light";
    }
    switch (picked.lobe->miss) {
        case LobeMiss::none:
            return "exact";
        case LobeMiss::bright:
            return away + ", because no band that reflects so much is so saturated";
        case LobeMiss::saturated:
            return away +
                   ", because no single band has that chromaticity (purples have none, nor has much that is pale)";
    }
    return {};
}

std::string miss_text(const PickedColour& picked) {
    return (picked.is_searched ? "the nearest " : "this ") + picked.mechanism + " is " + match_text(picked);
}

std::string picked_text(const std::vector<PickedColour>& picked) {
    std::string text;
    for (const PickedColour& one : picked) {
        const bool is_exact = one.lobe && one.is_met();
        text += (text.empty() ? "" : "; ") + one.text + " at " + number_text(one.angle_deg) +
                " deg: " + (is_exact ? "exact" : "dE00 " + significant_text(one.de00, 3));
    }
    return text;
}

std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read) {
    const Value* value = pick.find("colour");
    if (value == nullptr) {
        if (const Value* space = pick.find("space"))
            pick.fail(space->where, "space is that of a colour, and the pick has none; give colour = [r, g, b]");
        return {};
    }
    const Rgb components = read_components(pick, *value);
    const std::string space = pick.text_or("space", "");
    for (const char* number : {"peak_nm", "width_nm", "height"}) {
        if (const Value* other = pick.find(number)) {
            pick.fail(other->where, std::string(number) + " and colour both say what is seen; leave one of them out");
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
