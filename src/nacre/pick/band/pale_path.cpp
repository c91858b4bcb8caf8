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

namespace nacre {
namespace {

constexpr double little_chroma = 0.4;     // chosen: below it a strip looks grey
constexpr double hardly_coloured = 0.03;  // chosen: chroma of a pick that is hardly a colour
constexpr int points = 16;                // of a path

double chroma_of(const Oklab& colour) {
    return std::hypot(colour.a, colour.b);
}

Oklab seen_at(const PaletteCurve& curve, const LobeColour& colour_of, double angle_deg) {
    return xyz_to_oklab(colour_of(curve.at(Incidence::from_degrees(angle_deg))));
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
        const Oklab a = seen_at(curve, colour_of, from_deg), b = seen_at(curve, colour_of, to_deg);
        const double paler = std::min(chroma_of(a), chroma_of(b));
        if (paler < hardly_coloured) continue;
        double least = paler;
        for (int point = 1; point < points; ++point) {
            const double angle_deg = std::lerp(from_deg, to_deg, static_cast<double>(point) / points);
            least = std::min(least, chroma_of(seen_at(curve, colour_of, angle_deg)));
        }
        if (least < little_chroma * paler)
            paths.push_back(
                {order[i], order[i + 1], least / paler, std::round(0.5 * (from_deg + to_deg)), between(a, b), false});
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
    return text + "no band leads from one to the other through other hues, but a structure may: --mechanism stack";
}

}  // namespace nacre
