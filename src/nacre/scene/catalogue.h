#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/observer.h"
#include "nacre/lut/gamut.h"
#include "nacre/scene/table.h"

namespace nacre {

/// The number that a texel's components are stored as.
enum class PixelFormat { half_float, single_float };

/// How a band of reflectance becomes XYZ: in closed form, or by running moments, which err by CIEDE2000 0.001 or less
/// but for rare flanks (see lobe_to_xyz_fast()).
enum class Integral { exact, fast };

/// What is written for a LUT.
enum class LutOutput { exr, json, png };

/// What a swatch shows: see [swatch.NAME] in the documentation of scenes.
enum class SwatchKind { plane, palette, strip, sphere, picks };

/// A word of the scene file and what it means. The first of a list is its default.
template <typename Meaning>
struct Word {
    std::string_view name;
    Meaning meaning;
    std::string_view description;
};

inline constexpr std::array observer_words{
    Word<Observer>{"cie1931_2deg", Observer::cie1931_2deg, "CIE 1931, 2 degrees"},
    Word<Observer>{"cie1964_10deg", Observer::cie1964_10deg, "CIE 1964, 10 degrees"},
};
inline constexpr std::array adaptation_words{
    Word<Adaptation>{"bradford", Adaptation::bradford, "the illuminant's white becomes D65, Bradford cones"},
    Word<Adaptation>{"cat16", Adaptation::cat16, "the illuminant's white becomes D65, CAT16 cones"},
    Word<Adaptation>{"none", Adaptation::none, "the illuminant's cast stays in the LUT"},
};
inline constexpr std::array gamut_words{
    Word<Gamut>{"keep", Gamut::keep, "negative components stay, and are counted"},
    Word<Gamut>{"clip", Gamut::clip, "negative components become 0"},
    Word<Gamut>{"compress", Gamut::compress,
                "less chroma at the same hue and lightness (Oklab), until nothing is negative"},
};
/// The same for pictures, which have to show something.
inline constexpr std::array swatch_gamut_words{
    Word<Gamut>{"compress", Gamut::compress, "bent into what sRGB shows, so that neighbours stay distinct"},
    Word<Gamut>{"clip", Gamut::clip, "cut at what the display shows"},
};
inline constexpr std::array format_words{
    Word<PixelFormat>{"half", PixelFormat::half_float, "16 bits per component"},
    Word<PixelFormat>{"float", PixelFormat::single_float, "32 bits per component"},
};
inline constexpr std::array integral_words{
    Word<Integral>{"exact", Integral::exact, "in closed form, to rounding"},
    Word<Integral>{"fast", Integral::fast, "by running moments, within CIEDE2000 0.003"},
};
inline constexpr std::array output_words{
    Word<LutOutput>{"exr", LutOutput::exr, "the texture"},
    Word<LutOutput>{"json", LutOutput::json, "what the texture is, for tools"},
    Word<LutOutput>{"png", LutOutput::png, "the strip swatch, to look at"},
};
inline constexpr std::array swatch_words{
    Word<SwatchKind>{"plane", SwatchKind::plane, "peak wavelength against angle, with the picks"},
    Word<SwatchKind>{"palette", SwatchKind::palette, "width against height at a pick's peak"},
    Word<SwatchKind>{"strip", SwatchKind::strip, "the LUT with its axis"},
    Word<SwatchKind>{"sphere", SwatchKind::sphere, "a lit ball"},
    Word<SwatchKind>{"picks", SwatchKind::picks, "picked colours beside those that are reached"},
};

template <typename Words>
std::vector<std::string> names_of(const Words& words) {
    std::vector<std::string> names;
    for (const auto& word : words) names.emplace_back(word.name);
    return names;
}

template <typename Words>
std::string_view name_of(const Words& words, decltype(words.front().meaning) meaning) {
    for (const auto& word : words) {
        if (word.meaning == meaning) return word.name;
    }
    return {};
}

/// The meaning of a name, or an Error that offers the known ones:
/// `... unknown observer "cie1932"; known: cie1931_2deg, cie1964_10deg`.
template <typename Words>
auto meaning_of(const Words& words, std::string_view what, std::string_view name, const Table& table,
                const Where& where) {
    for (const auto& word : words) {
        if (word.name == name) return word.meaning;
    }
    table.fail(where,
               "unknown " + std::string(what) + " " + in_quotes(name) + "; known: " + comma_separated(names_of(words)));
}

/// The same for a key of a table; the list's first word if the key is missing.
template <typename Words>
auto read_word(const Table& table, std::string_view key, std::string_view what, const Words& words) {
    const Value* value = table.find(key);
    if (value == nullptr) return words.front().meaning;
    return meaning_of(words, what, table.checked_text(key, *value), table, value->where);
}

}  // namespace nacre
