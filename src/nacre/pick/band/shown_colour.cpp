#include "nacre/pick/band/shown_colour.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/oklab.h"
#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

Xyz with_chroma(const Oklab& colour, double share) {
    return oklab_to_xyz({colour.lightness, share * colour.a, share * colour.b});
}

}  // namespace

ShownColour shown_colour(const ExactBands& bands, const Light& light, const Xyz& colour) {
    const glm::dmat3 to_light = glm::inverse(light.adaptation);
    // Of numbers that were meant as 0 to 255, the search for the brightest would end at black.
    const auto brightest = [&](const Xyz& c) {
        const double times_white = std::max(c.y, 1.0);
        return bands.brightest(adapt(to_light, scaled(c, 1.0 / times_white))) / times_white;
    };
    constexpr double black = 1e-7;  // less has no chromaticity
    if (std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z) < black) return {};
    const Oklab picked = xyz_to_oklab(colour);
    if (!(picked.lightness > 0.0)) return {{}, 0.0, 1.0};
    if (const double most = brightest(colour); most > 0.0) {
        constexpr double rounding = 1e-5;  // CIEDE2000 0.0003
        if (most > 1.0 - rounding) return {colour};
        return {scaled(colour, most), most, 1.0};
    }
    // The share of the chroma that equals the share of the lightness, to a tenth of what is visible: the rule of false
    // position, which halves an end that stays.
    constexpr double invisible = 1e-3;
    constexpr int most_steps = 20;
    double inside = 0.0, outside = 1.0, lighter = 1.0, darker = -1.0;
    for (int i = 0, stays = 0; i < most_steps; ++i) {
        const double middle = inside + (outside - inside) * lighter / (lighter - darker);
        const double excess = std::cbrt(std::min(brightest(with_chroma(picked, middle)), 1.0)) - middle;
        if (excess >= 0.0) {
            inside = middle;
            lighter = excess;
            if (excess < invisible) break;
            if (stays > 0) darker *= 0.5;
            stays = 1;
        } else {
            outside = middle;
            darker = excess;
            if (stays < 0) lighter *= 0.5;
            stays = -1;
        }
    }
    // A step further in: next to the locus bands may not reach what other reflectances do.
    inside = std::max(inside - invisible, 0.0);
    const Xyz paler = with_chroma(picked, inside);
    const double share = std::min(brightest(paler), 1.0);
    return {scaled(paler, share), share * paler.y / std::max(colour.y, paler.y), inside};
}

}  // namespace nacre
