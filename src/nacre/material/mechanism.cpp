#include "nacre/material/mechanism.h"

#include <array>

namespace nacre {
namespace {

// One row per mechanism, in MechanismModel's order: its name in a scene, and what it depends on.
struct MechanismRow {
    std::string_view name;
    Quantity quantity;
};
constexpr std::array mechanism_rows{
    MechanismRow{"palette", Quantity::incidence},  MechanismRow{"film", Quantity::incidence},
    MechanismRow{"stack", Quantity::incidence},    MechanismRow{"grating", Quantity::grating_u},
    MechanismRow{"crystal", Quantity::incidence},  MechanismRow{"scatter", Quantity::cos_scatter},
    MechanismRow{"measured", Quantity::incidence},
};

static_assert(mechanism_rows.size() == std::variant_size_v<MechanismModel>, "one row per mechanism");

}  // namespace

std::vector<std::string> mechanism_names() {
    std::vector<std::string> names;
    for (const MechanismRow& row : mechanism_rows) names.emplace_back(row.name);
    return names;
}

std::string_view mechanism_name(const Mechanism& mechanism) {
    return mechanism_rows[mechanism.index()].name;
}

Quantity quantity_of(const Mechanism& mechanism) {
    return mechanism_rows[mechanism.index()].quantity;
}

bool is_layered(const Mechanism& mechanism) {
    return std::holds_alternative<Film>(mechanism) || std::holds_alternative<Stack>(mechanism) ||
           std::holds_alternative<Crystal>(mechanism);
}

}  // namespace nacre
