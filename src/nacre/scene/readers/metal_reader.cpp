// A metal as renderers describe it: its colour at normal incidence, and a tint towards grazing.
#include "nacre/scene/readers/metal_reader.h"

#include <vector>

#include "nacre/pick/coloured_metal.h"

namespace nacre {
namespace {

constexpr Allowed allowed_f0{0.0, most_f0};
constexpr Allowed allowed_tint{0.0, 1.0};

}  // namespace

std::array<double, 3> read_rec709(const Table& table, std::string_view key, const Allowed& allowed) {
    const Value& value = *table.find(key);
    const std::vector<double> numbers = table.checked_numbers(key, value, allowed);
    if (numbers.size() != 3) {
        table.fail(value.where, std::string(key) + " has " + std::to_string(numbers.size()) +
                                    " numbers; give three, of linear Rec.709: [red, green, blue]");
    }
    return {numbers[0], numbers[1], numbers[2]};
}

std::optional<MetalColour> read_metal(const Table& table, std::string_view key) {
    const bool may_be = key == "substrate" || key == "metal";
    if (may_be) {
        for (const std::string_view known : {"f0", "edge_tint"}) table.know(known);
    }
    const Value* f0 = table.find("f0");
    const Value* edge_tint = table.find("edge_tint");
    if (f0 == nullptr && edge_tint == nullptr) return {};
    if (!may_be) {
        table.fail((f0 != nullptr ? f0 : edge_tint)->where,
                   "f0 has no meaning for " + std::string(key) +
                       ": it is the colour of a metal, which a substrate or the metal of a base may be; give a number, "
                       "{ n, k }, or the name of a material");
    }
    if (f0 == nullptr) table.fail_missing("f0", "edge_tint needs it: the metal's colour, [red, green, blue]");
    for (const Table::Entry& entry : table.entries()) {
        if (entry.key != "n" && entry.key != "k" && entry.key != "material") continue;
        table.fail(entry.key_where,
                   "f0 and " + entry.key + " are both given; n and k follow from f0, so remove one of them");
    }
    MetalColour metal{read_rec709(table, "f0", allowed_f0)};
    if (edge_tint != nullptr) metal.edge_tint = read_rec709(table, "edge_tint", allowed_tint);
    return metal;
}

Parameter f0_parameter(const std::string& prefix, const std::string& of_what, const MetalColour& colour,
                       const std::function<Index&(Mechanism&)>& find) {
    return {prefix + "f0", "F0" + of_what, allowed_f0,
            [find, colour](Mechanism& m, double level) { find(m) = Index(coloured_metal(with_f0(colour, level))); }};
}

}  // namespace nacre
