// parse_yaml() of the module: yaml-cpp is no library of headers, so the page's own reader of YAML makes the tree.
#include <emscripten/emscripten.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "io/scene/yaml_tree.h"
#include "nacre/base/error.h"

// The tree of page/yaml.ts as JSON, or { "error", "line" }. Whoever calls frees it.
EM_JS(char*, nacre_yaml, (const char* text), {
    const json = Module.parseYaml(UTF8ToString(text));
    const size = lengthBytesUTF8(json) + 1;
    const bytes = _malloc(size);
    stringToUTF8(json, bytes, size);
    return bytes;
});

namespace nacre {
namespace {

YamlNode node_of(const nlohmann::json& json) {
    using Kind = YamlNode::Kind;
    YamlNode node;
    const std::string kind = json.at("kind");
    node.kind = kind == "text" ? Kind::text : kind == "list" ? Kind::list : kind == "map" ? Kind::map : Kind::nothing;
    node.line = json.at("line");
    if (node.kind == Kind::text) {
        node.text = json.at("text");
        node.text_line = json.at("textLine");
    }
    if (node.kind == Kind::map) node.keys = json.at("keys").get<std::vector<std::string>>();
    if (json.contains("items")) {
        for (const nlohmann::json& item : json.at("items")) node.items.push_back(node_of(item));
    }
    return node;
}

YamlNode parsed(const std::string& text, const std::string& name) {
    char* const answer = nacre_yaml(text.c_str());
    const nlohmann::json json = nlohmann::json::parse(answer);
    std::free(answer);
    if (!json.contains("error")) return node_of(json);
    throw Error(name + ":" + std::to_string(json.at("line").get<int>()) + ": " + json.at("error").get<std::string>());
}

}  // namespace

// A scene is planned anew with every move of a slider, and its materials are read again: each text is parsed once.
YamlNode parse_yaml(std::string_view text, const std::string& name) {
    static std::map<std::string, YamlNode, std::less<>> known;
    const auto found = known.find(text);
    if (found != known.end()) return found->second;
    return known.emplace(std::string(text), parsed(std::string(text), name)).first->second;
}

}  // namespace nacre
