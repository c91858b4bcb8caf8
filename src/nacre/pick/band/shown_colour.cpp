#include "nacre/pick/band/shown_colour.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/oklab.h"

namespace nacre {
namespace {

Xyz scaled(const Xyz& colour, double factor) {
    return {colour.x * factor, colour.y * factor, colour.z * factor};
}

Xyz with_chroma(const Oklab& colour, double share) {
    return oklab_to_xyz({colour.lightness, share * colour.a, share * colour.b});
}

}  // namespace

ShownColour shown_colour(const ExactBands& bands, const Light& light, const Xyz& colour) {
    const glm::dmat3 to_light = glm::inverse(light.adaptation);
    const auto brightest = [&](const Xyz& c) { return bands.brightest(adapt(to_light, c)); };
    constexpr double black = 1e-7;  // less has no chromaticity
    if (std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z) < black) return {};
    const Oklab picked = xyz_to_oklab(colour);
    if (!(picked.lightness > 0.0)) return {{}, 0.0, 1.0};
    if (const double most = brightest(colour); most > 0.0) {
        constexpr double rounding = 1e-5;  // CIEDE2000 0.0003
        if (most > 1.0 - rounding) return {colour};
        return {scaled(colour, most), most, 1.0};
    }
    // Next to the ends of the spectrum a colour may have bands although the brightest was not found.
    const Xyz in_light = adapt(to_light, colour);
    if (bands.find(in_light, BandKind::band, 0.0) || bands.find(in_light, BandKind::notch, 0.0)) return {colour};
    // The share of the chroma that equals the share of the lightness, by bisection to a tenth of what is visible.
    double inside = 0.0;
    double outside = 1.0;
    constexpr int halvings = 10;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        const double lightness = std::cbrt(std::min(brightest(with_chroma(picked, middle)), 1.0));
        (lightness >= middle ? inside : outside) = middle;
    }
    const Xyz paler = with_chroma(picked, inside);
    const double share = std::min(brightest(paler), 1.0);
    return {scaled(paler, share), share * paler.y / std::max(colour.y, paler.y), inside};
}

}  // namespace nacre
