#include "pipeline/pick_scene.h"

#include <algorithm>
#include <cctype>

#include "nacre/base/text.h"

namespace nacre {
namespace {

std::string heading(const char* kind, const std::string& name) {
    const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char character) {
        return std::isalnum(character) != 0 || character == '_' || character == '-';
    });
    return "[" + std::string(kind) + "." + (is_bare ? name : toml_string(name)) + "]\n";
}

}  // namespace

std::string picks_toml(const std::vector<PickLine>& picks) {
    std::string text = "[\n";
    for (const PickLine& pick : picks) {
        text += "    " + pick.toml + ",";
        if (!pick.comment.empty()) text += "  # " + pick.comment;
        text += "\n";
    }
    return text + "]";
}

std::string scene_text(const PickScene& scene) {
    std::string text = "nacre = 1\n\n" + scene.comments + heading("material", scene.name) + scene.material;
    if (!scene.picks.empty()) text += "picks = " + scene.picks + "\n";
    const auto add_swatch = [&](const std::string& draw) {
        text += "\n" + heading("swatch", scene.name + "_" + draw) + "draw = " + toml_string(draw) +
                "\nmaterial = " + toml_string(scene.name) + "\n";
    };
    if (scene.has_colours) add_swatch("picks");
    add_swatch("strip");
    add_swatch("sphere");
    return text;
}

}  // namespace nacre
