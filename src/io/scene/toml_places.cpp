// One of the two files that know toml++; the other is toml_tree.cpp.
#include "io/scene/toml_places.h"

#include <toml++/toml.h>
#include <algorithm>
#include <cstddef>
#include <string_view>

#include "io/scene/toml_tree.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

std::string key_in_path(std::string_view key) {
    const bool is_bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    return is_bare ? std::string(key) : toml_string(key);
}

class PlaceCollector {
public:
    void add(const toml::node& node, const std::string& path) {
        TomlPlace place;
        place.path = path;
        const toml::source_region& source = node.source();
        place.line = static_cast<int>(source.begin.line);
        place.column = static_cast<int>(source.begin.column);
        place.end_line = static_cast<int>(source.end.line);
        place.end_column = static_cast<int>(source.end.column);
        if (const auto* value = node.as_boolean()) place.value = value->get();
        if (const auto* value = node.as_integer()) place.value = static_cast<double>(value->get());
        if (const auto* value = node.as_floating_point()) place.value = value->get();
        if (const auto* value = node.as_string()) place.value = value->get();
        if (!path.empty()) places.push_back(std::move(place));
        if (const auto* array = node.as_array()) {
            for (std::size_t i = 0; i < array->size(); ++i) add((*array)[i], path + "[" + std::to_string(i) + "]");
        }
        if (const auto* table = node.as_table()) {
            for (auto&& [key, item] : *table) add(item, (path.empty() ? "" : path + ".") + key_in_path(key.str()));
        }
    }

    std::vector<TomlPlace> places;
};

}  // namespace

std::vector<TomlPlace> toml_places(const std::string& text, const std::string& name) {
    // It has the limits that keep toml++ from running away, and the messages.
    parse_toml(text, name);
    PlaceCollector collector;
    collector.add(toml::parse(text, name), "");
    return std::move(collector.places);
}

}  // namespace nacre
