#include "nacre/pick/colour_path.h"

#include <algorithm>
#include <cmath>

#include "nacre/colour/hue_name.h"
#include "nacre/colour/oklab.h"

namespace nacre {
namespace {

constexpr std::size_t most_named = 4;  // hues; more are no way but a rainbow
constexpr double little_chroma = 0.4;  // chosen: below this share a strip looks grey

void add_hue(std::vector<std::string>& hues, std::string_view hue) {
    if (hues.empty() || hues.back() != hue) hues.emplace_back(hue);
}

}  // namespace

bool ColourPath::is_pale() const {
    return chroma < little_chroma;
}

ColourPath colour_path(std::span<const Xyz> colours) {
    std::vector<Oklab> path;
    for (const Xyz& colour : colours) path.push_back(xyz_to_oklab(colour));
    const double paler = std::min(chroma_of(path.front()), chroma_of(path.back()));
    const double coloured = std::max(little_chroma * paler, hardly_coloured);
    ColourPath found;
    std::vector<std::string> hues;
    for (const Oklab& colour : path) {
        const double chroma = chroma_of(colour);
        if (paler >= hardly_coloured) found.chroma = std::min(found.chroma, chroma / paler);
        add_hue(hues, chroma < coloured ? grey_name(colour) : hue_name(colour));
    }
    if (hues.size() > 2) found.hues.assign(hues.begin() + 1, hues.end() - 1);
    return found;
}

ColourPath joined(std::span<const ColourPath> paths) {
    ColourPath whole;
    for (const ColourPath& path : paths) {
        whole.chroma = std::min(whole.chroma, path.chroma);
        for (const std::string& hue : path.hues) add_hue(whole.hues, hue);
    }
    return whole;
}

std::string path_text(const ColourPath& path) {
    if (path.hues.size() > most_named) return "through many hues";
    std::string text;
    for (std::size_t i = 0; i < path.hues.size(); ++i)
        text += (i == 0 ? "through " : i + 1 < path.hues.size() ? ", " : " and ") + path.hues[i];
    return text;
}

}  // namespace nacre
