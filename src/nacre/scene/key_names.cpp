// What artists may call a key: words of renderers, of other programs and of everyday language.
#include "nacre/scene/key_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "nacre/base/names.h"

namespace nacre {
namespace {

struct Synonym {
    std::string_view word;
    std::string_view key;
};

// In lower case, without _ and -. A word may stand for several keys: the first that is known at the place counts.
constexpr std::array synonyms{
    Synonym{"absorption", "k"},
    Synonym{"albedo", "base"},
    Synonym{"amplitude", "height"},
    Synonym{"angle", "angle_deg"},
    Synonym{"azimuth", "azimuth_deg"},
    Synonym{"background", "base"},
    Synonym{"bandwidth", "width_nm"},
    Synonym{"basecolor", "base"},
    Synonym{"basecolour", "base"},
    Synonym{"basecolour", "f0"},
    Synonym{"basecolor", "f0"},
    Synonym{"bits", "format"},
    Synonym{"coating", "coat"},
    Synonym{"colormanagement", "colour"},
    Synonym{"colorspace", "space"},
    Synonym{"colourspace", "space"},
    Synonym{"concentration", "volume_fraction"},
    Synonym{"count", "repeat"},
    Synonym{"de", "max_de00"},
    Synonym{"de2000", "max_de00"},
    Synonym{"deltae", "max_de00"},
    Synonym{"depth", "depth_nm"},
    Synonym{"diameter", "diameter_nm"},
    Synonym{"diffuse", "base"},
    Synonym{"d", "thickness_nm"},
    Synonym{"edgecolor", "edge_tint"},
    Synonym{"edgecolour", "edge_tint"},
    Synonym{"error", "max_de00"},
    Synonym{"eta", "index"},
    Synonym{"eta", "n"},
    Synonym{"extinction", "k"},
    Synonym{"f0", "f0"},
    Synonym{"f0", "substrate"},
    Synonym{"files", "outputs"},
    Synonym{"fwhm", "width_nm"},
    Synonym{"gain", "height"},
    Synonym{"gratingu", "angle_deg"},
    Synonym{"hex", "colour"},
    Synonym{"illuminant", "light"},
    Synonym{"image", "swatch"},
    Synonym{"intensity", "height"},
    Synonym{"ior", "index"},
    Synonym{"ior", "n"},
    Synonym{"kind", "mechanism"},
    Synonym{"kind", "draw"},
    Synonym{"lambda", "peak_nm"},
    Synonym{"lamp", "illuminant"},
    Synonym{"lightsource", "illuminant"},
    Synonym{"lines", "grooves"},
    Synonym{"model", "mechanism"},
    Synonym{"n", "index"},
    Synonym{"ocio", "config"},
    Synonym{"ocio", "colour"},
    Synonym{"output", "outputs"},
    Synonym{"pattern", "draw"},
    Synonym{"picture", "swatch"},
    Synonym{"pitch", "period_nm"},
    Synonym{"preview", "swatch"},
    Synonym{"quality", "accuracy"},
    Synonym{"quality", "max_de00"},
    Synonym{"radius", "radius_nm"},
    Synonym{"reflectance", "quantity"},
    Synonym{"reflectivity", "f0"},
    Synonym{"refractiveindex", "index"},
    Synonym{"refractiveindex", "n"},
    Synonym{"render", "swatch"},
    Synonym{"resolution", "size"},
    Synonym{"rgb", "colour"},
    Synonym{"perceptualroughness", "roughness"},
    Synonym{"rgb", "f0"},
    Synonym{"spacing", "spacing_nm"},
    Synonym{"spacing", "period_nm"},
    Synonym{"specularcolor", "edge_tint"},
    Synonym{"specularcolour", "edge_tint"},
    Synonym{"texture", "lut"},
    Synonym{"textures", "lut"},
    Synonym{"theta", "angle_deg"},
    Synonym{"thickness", "thickness_nm"},
    Synonym{"times", "repeat"},
    Synonym{"tint", "colour"},
    Synonym{"tint", "edge_tint"},
    Synonym{"tolerance", "max_de00"},
    Synonym{"transmission", "quantity"},
    Synonym{"transmittance", "quantity"},
    Synonym{"type", "mechanism"},
    Synonym{"type", "draw"},
    Synonym{"underlay", "base"},
    Synonym{"version", "nacre"},
    Synonym{"wavelength", "peak_nm"},
    Synonym{"wavelengthnm", "peak_nm"},
    Synonym{"whitebalance", "illuminant"},
    Synonym{"whitepoint", "illuminant"},
};

std::string plain_word(std::string_view key) {
    std::string word;
    for (const char c : key) {
        if (c != '_' && c != '-' && c != ' ') word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return word;
}

}  // namespace

std::string american_spelling(std::string_view key) {
    constexpr std::string_view british = "colour";
    const std::size_t at = key.find(british);
    if (at == std::string_view::npos) return {};
    return std::string(key.substr(0, at)) + "color" + std::string(key.substr(at + british.size()));
}

bool is_same_key(std::string_view a, std::string_view b) {
    return a == b || (!a.empty() && !b.empty() && (american_spelling(a) == b || american_spelling(b) == a));
}

std::string meant_key(std::string_view wrong, std::span<const std::string> known) {
    const std::string word = plain_word(wrong);
    for (const Synonym& synonym : synonyms) {
        if (synonym.word == word && std::find(known.begin(), known.end(), synonym.key) != known.end())
            return std::string(synonym.key);
    }
    const std::vector<std::string> near = nearest_names(wrong, known, 1);
    return near.empty() ? std::string() : near.front();
}

}  // namespace nacre
