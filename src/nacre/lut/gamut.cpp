#include "nacre/lut/gamut.h"

#include <algorithm>
#include <cassert>

namespace nacre {

Rgb clip_to_gamut(Rgb colour) {
    const auto clip = [](double value) { return value > 0.0 ? value : 0.0; };
    return {clip(colour.r), clip(colour.g), clip(colour.b)};
}

GamutReport gamut_report(const Image<Rgb>& image) {
    GamutReport report;
    for (const Rgb& pixel : image) {
        const double smallest = std::min({pixel.r, pixel.g, pixel.b});
        if (smallest < gamut_tolerance) ++report.outside;
        report.most_negative = std::min(report.most_negative, smallest);
    }
    return report;
}

GamutRule::GamutRule(Gamut gamut, const std::optional<glm::dmat3>& rgb_of_xyz) : gamut_(gamut) {
    assert(gamut != Gamut::compress || rgb_of_xyz);
    if (gamut == Gamut::compress) compression_.emplace(*rgb_of_xyz);
}

void GamutRule::apply(Image<Rgb>& image, const Image<Xyz>& xyz) const {
    switch (gamut_) {
        case Gamut::keep:
            break;
        case Gamut::clip:
            std::transform(image.begin(), image.end(), image.begin(), clip_to_gamut);
            break;
        case Gamut::compress:
            assert(xyz.width() == image.width() && xyz.height() == image.height());
            std::transform(image.begin(), image.end(), xyz.begin(), image.begin(), *compression_);
            break;
    }
}

}  // namespace nacre
