#include "nacre/colour/hue_name.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nacre {
namespace {

struct NamedHue {
    std::string_view name;
    double angle_deg;
};

// The hues in Oklab of #ff0000, #ffa500, #ffff00, #00ff00, #00ffff, #0000ff, #663399 (rebeccapurple), #ff00ff and
// #ff1493 (deeppink). CSS gives purple (#800080) the hue of magenta, which is redder than what most people call purple.
constexpr std::array<NamedHue, 9> named_hues{{{"red", 29.2},
                                              {"orange", 70.7},
                                              {"yellow", 109.8},
                                              {"green", 142.5},
                                              {"cyan", 194.8},
                                              {"blue", 264.1},
                                              {"purple", 303.4},
                                              {"magenta", 328.4},
                                              {"pink", 356.9}}};

// Chosen: above and below them, a colour without hue is called white and black.
constexpr double least_white = 0.9, most_black = 0.15;

}  // namespace

std::string_view hue_name(const Oklab& colour) {
    constexpr double degrees_per_radian = 57.29577951308232;
    const double angle_deg = std::atan2(colour.b, colour.a) * degrees_per_radian;
    const auto distance = [&](const NamedHue& hue) {
        return std::abs(std::remainder(angle_deg - hue.angle_deg, 360.0));
    };
    return std::min_element(named_hues.begin(), named_hues.end(),
                            [&](const NamedHue& a, const NamedHue& b) { return distance(a) < distance(b); })
        ->name;
}

std::string_view grey_name(const Oklab& colour) {
    return colour.lightness > least_white ? "white" : colour.lightness < most_black ? "black" : "grey";
}

}  // namespace nacre
