#include "nacre/pick/band/pale_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>

#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/oklab.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/optics/incidence.h"
#include "nacre/pick/colour_path.h"

namespace nacre {
namespace {

std::vector<Xyz> seen_between(const PaletteCurve& curve, const LobeColour& colour_of, double from_deg, double to_deg) {
    std::vector<Xyz> colours;
    for (std::size_t i = 0; i < colours_of_path; ++i) {
        const double share = static_cast<double>(i) / (colours_of_path - 1);
        colours.push_back(colour_of(curve.at(Incidence::from_degrees(std::lerp(from_deg, to_deg, share)))));
    }
    return colours;
}

Rgb to_srgb(const Xyz& colour) {  // linear
    const Xyz rgb = adapt(xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene")), colour);
    return {rgb.x, rgb.y, rgb.z};
}

double encoded(double linear) {  // IEC 61966-2-1
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

bool is_displayed(const Rgb& colour) {
    const auto [least, most] = std::minmax({colour.r, colour.g, colour.b});
    return least >= 0.0 && most <= 1.0;
}

// Halfway between two colours, as saturated as sRGB allows.
Xyz between(const Oklab& a, const Oklab& b) {
    const double hue_a = std::atan2(a.b, a.a);
    const double turn = std::remainder(std::atan2(b.b, b.a) - hue_a, 2.0 * std::numbers::pi);
    const double hue = hue_a + 0.5 * turn;
    const double lightness = 0.5 * (a.lightness + b.lightness);
    double chroma = 0.5 * (chroma_of(a) + chroma_of(b));
    constexpr double step = 0.98;
    for (;; chroma *= step) {
        const Xyz colour = oklab_to_xyz({lightness, chroma * std::cos(hue), chroma * std::sin(hue)});
        if (is_displayed(to_srgb(colour)) || chroma < hardly_coloured) return colour;
    }
}

}  // namespace

std::vector<PalePath> pale_paths(const Palette& palette, const LobeColour& colour_of) {
    const PaletteCurve curve(palette);
    std::vector<std::size_t> order(palette.picks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return palette.picks[a].angle_deg < palette.picks[b].angle_deg;
    });
    std::vector<PalePath> paths;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const double from_deg = palette.picks[order[i]].angle_deg;
        const double to_deg = palette.picks[order[i + 1]].angle_deg;
        const std::vector<Xyz> colours = seen_between(curve, colour_of, from_deg, to_deg);
        const ColourPath path = colour_path(colours);
        if (!path.is_pale()) continue;
        paths.push_back({order[i], order[i + 1], path.chroma, std::round(0.5 * (from_deg + to_deg)),
                         between(xyz_to_oklab(colours.front()), xyz_to_oklab(colours.back())), false});
    }
    return paths;
}

std::vector<PalePath> pale_paths_with_advice(
    const Palette& palette, const std::vector<ColourOrBand>& picks, const LobeColour& colour_of,
    const std::function<std::vector<Lobe>(const std::vector<ColourOrBand>&)>& bands) {
    std::vector<PalePath> paths = pale_paths(palette, colour_of);
    for (PalePath& path : paths) {
        const std::vector<ColourOrBand> three{picks[path.from], {path.middle_deg, path.middle, {}}, picks[path.to]};
        const std::vector<Lobe> chosen = bands(three);
        Palette trial{{}, palette.shape};
        for (std::size_t i = 0; i < three.size(); ++i) trial.picks.push_back({three[i].angle_deg, chosen[i]});
        path.middle_helps = pale_paths(trial, colour_of).empty();
    }
    return paths;
}

std::string middle_pick_text(const PalePath& path) {
    constexpr std::string_view digits = "0123456789abcdef";
    const Rgb linear = to_srgb(path.middle);
    std::string hex = "#";
    for (const double component : {linear.r, linear.g, linear.b}) {
        const auto byte = static_cast<std::size_t>(std::lround(255.0 * encoded(std::clamp(component, 0.0, 1.0))));
        hex += digits[byte / 16];
        hex += digits[byte % 16];
    }
    return "\"" + hex + "@" + number_text(path.middle_deg) + "\"";
}

std::string pale_path_text(const PalePath& path, const Palette& palette) {
    const std::string text = "between " + number_text(palette.picks[path.from].angle_deg) + " and " +
                             number_text(palette.picks[path.to].angle_deg) + " deg the colour passes through grey (" +
                             significant_text(100.0 * path.chroma, 2) + " % of the chroma is left); ";
    if (path.middle_helps)
        return text + "the pick " + middle_pick_text(path) + " between them leads through other hues";
    return text + "no band leads from one to the other through other hues";
}

}  // namespace nacre
