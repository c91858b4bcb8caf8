#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// A word of the scene file and what it means. The first of a list is its default.
template <typename Meaning>
struct Word {
    std::string_view name;
    Meaning meaning;
    std::string_view description;
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

}  // namespace nacre
