#pragma once

#include <array>
#include <string>
#include <string_view>

#include "nacre/base/names.h"
#include "nacre/base/words.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/observer.h"
#include "nacre/scene/table.h"

namespace nacre {

inline constexpr std::array observer_words{
    Word<Observer>{"cie1931_2deg", Observer::cie1931_2deg, "CIE 1931, 2 degrees"},
    Word<Observer>{"cie1964_10deg", Observer::cie1964_10deg, "CIE 1964, 10 degrees"},
};
inline constexpr std::array adaptation_words{
    Word<Adaptation>{"bradford", Adaptation::bradford, "the illuminant's white becomes D65, Bradford cones"},
    Word<Adaptation>{"cat16", Adaptation::cat16, "the illuminant's white becomes D65, CAT16 cones"},
    Word<Adaptation>{"none", Adaptation::none, "the illuminant's cast stays in the LUT"},
};
/// The meaning of a name, or a SceneError that offers the known ones:
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

/// The same for a key of a table; the list's first word if the key is missing. Notes mistakes, and then gives the
/// first word, too.
template <typename Words>
auto read_word(const Table& table, std::string_view key, std::string_view what, const Words& words) {
    auto meaning = words.front().meaning;
    if (const Value* value = table.find(key)) {
        attempt(table, value->where,
                [&] { meaning = meaning_of(words, what, table.checked_text(key, *value), table, value->where); });
    }
    return meaning;
}

}  // namespace nacre
