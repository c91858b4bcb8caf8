#include "nacre/bake/gamut.h"

#include <algorithm>
#include <cassert>

namespace nacre {

Rgb clip_to_gamut(Rgb colour) {
    const auto clip = [](double value) { return value > 0.0 ? value : 0.0; };
    return {clip(colour.r), clip(colour.g), clip(colour.b)};
}

Rgb compress_to_gamut(Rgb colour, double luminance) {
    assert(luminance >= 0.0);
    // colour + t (Y - colour) = 0 for the component that needs the most of it.
    double t = 0.0;
    for (const double c : {colour.r, colour.g, colour.b}) {
        if (c < 0.0) t = std::max(t, c / (c - luminance));
    }
    const auto mix = [&](double c) { return c + t * (luminance - c); };
    // The component that is zero by construction is so within rounding; clip makes it exact.
    return clip_to_gamut({mix(colour.r), mix(colour.g), mix(colour.b)});
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

GamutReport fit_to_gamut(Gamut gamut, Image<Rgb>& image, const Image<Xyz>& xyz) {
    const GamutReport before = gamut_report(image);
    switch (gamut) {
        case Gamut::keep:
            break;
        case Gamut::clip:
            std::transform(image.begin(), image.end(), image.begin(), clip_to_gamut);
            break;
        case Gamut::compress:
            assert(xyz.width() == image.width() && xyz.height() == image.height());
            std::transform(image.begin(), image.end(), xyz.begin(), image.begin(),
                           [](const Rgb& rgb, const Xyz& colour) { return compress_to_gamut(rgb, colour.y); });
            break;
    }
    return before;
}

}  // namespace nacre
