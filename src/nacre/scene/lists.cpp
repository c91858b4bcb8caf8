// The names that a scene may use, gathered from the tables that give them their meaning.
#include "nacre/scene/lists.h"

#include <array>
#include <cstddef>

#include "nacre/colour/illuminant.h"
#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/gamut.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

// CIE 15:2018, in the order of illuminant_names().
constexpr std::array<std::string_view, 9> illuminant_descriptions{
    "average daylight, 6504 K",
    "warm daylight, 5003 K: graphic arts",
    "daylight, 5503 K",
    "blue daylight, 7504 K",
    "incandescent lamp, 2856 K",
    "equal power at all wavelengths",
    "fluorescent lamp, cool white, 4230 K",
    "fluorescent lamp, broad-band daylight, 6500 K",
    "fluorescent lamp, three narrow bands, 4000 K",
};

std::vector<ListedName> illuminants() {
    std::vector<ListedName> names;
    const std::vector<std::string_view> known = illuminant_names();
    for (std::size_t i = 0; i < known.size(); ++i)
        names.push_back({std::string(known[i]), std::string(illuminant_descriptions.at(i))});
    return names;
}

template <typename Rows>
std::vector<ListedName> listed(const Rows& rows) {
    std::vector<ListedName> names;
    for (const auto& row : rows) names.push_back({std::string(row.name), std::string(row.description)});
    return names;
}

constexpr std::array lists{
    NameList{"mechanisms", "what makes the colour of a material", "mechanism in [material.NAME]",
             [] { return listed(mechanism_rows()); }},
    NameList{"axes", "what x and y of a LUT may be, beside parameters of its material", "x and y in [lut.NAME]",
             [] { return listed(axis_kinds()); }},
    NameList{"effects", "what refines a colour and may be left out", "without in [accuracy]",
             [] { return listed(effect_rows()); }},
    NameList{"illuminants", "the light", "illuminant in [light]", illuminants},
    NameList{"observers", "the eye", "observer in [light]", [] { return listed(observer_words); }},
    NameList{"adaptations", "how the white of the light becomes D65", "adapt in [light]",
             [] { return listed(adaptation_words); }},
    NameList{"gamuts", "what becomes of colours outside the colour space", "gamut in [colour]",
             [] { return listed(gamut_words); }},
    NameList{"formats", "how texels are stored", "format in [lut.NAME]", [] { return listed(format_words); }},
    NameList{"outputs", "the files of a LUT", "outputs in [lut.NAME]", [] { return listed(output_words); }},
    NameList{"swatches", "what a picture shows", "draw in [swatch.NAME]", [] { return listed(swatch_words); }},
};

}  // namespace

std::span<const NameList> name_lists() {
    return lists;
}

}  // namespace nacre
