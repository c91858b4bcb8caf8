#include "nacre/accuracy/obstacle.h"

#include <algorithm>

#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

std::string error_text(double error) {
    return significant_text(error, 2);
}

std::string between_texels(const SettledLut& settled, const SearchEnd& end) {
    const Job& job = settled.lut.job;
    const AccuracyWish& wish = settled.lut.wish;
    std::string text =
        "interpolation between " + size_text(job) + " texels costs " + error_text(settled.predicted.interpolation);
    if (end.is_tired) return text + ", and it takes too long to try more: give a larger bound, or size";
    if (wish.width || (job.y && wish.height)) return text + ": leave size out, or give a larger one";
    text += ", and " + std::to_string(end.most_texels) + " texels are the most that are tried: give a larger bound";
    return job.y ? text + ", or size" : text;
}

}  // namespace

std::string obstacle(const SettledLut& settled, const SearchEnd& end) {
    if (settled.predicted.effects > 0.5 * settled.lut.wish.max_de00) {
        return "effects that the scene does without cost " + error_text(settled.predicted.effects) +
               ": take them out of without";
    }
    const Job& job = settled.lut.job;
    const ErrorSplit& split = settled.predicted;
    const auto& wavelengths = job.light->settings.wavelengths;
    if (split.quadrature > std::max({split.interpolation, split.spectrum, split.storage, split.spread})) {
        const QuadratureWish& points = settled.lut.wish.points;
        const bool is_given = points.hemisphere > 0 || points.sizes > 0 || points.slices > 0;
        return "sums over base, radii or slices cost " + error_text(split.quadrature) +
               (is_given ? ": give more of them in [accuracy], or none" : ": give a larger bound");
    }
    if (split.storage > std::max({split.interpolation, split.spectrum, split.spread})) {
        const bool is_half = settled.lut.format == PixelFormat::half_float;
        return is_half ? "half costs " + error_text(split.storage) + ": use float"
                       : "float costs " + error_text(split.storage) + ": give a larger bound";
    }
    if (end.lost_by_space > 0.5 * split.total) {
        return "colours come back from the colour space off by " + error_text(end.lost_by_space) +
               ": use another space, or gamut = \"clip\" or \"compress\"";
    }
    if (wavelengths && split.spectrum > 0.5 * split.interpolation) {
        return std::to_string(*wavelengths) + " wavelengths cost " + error_text(split.spectrum) +
               ": leave wavelengths out";
    }
    if (split.spread > split.interpolation) {
        return std::to_string(job.sampling.realisations) + " realisations of an irregular stack cost " +
               error_text(split.spread) +
               (settled.lut.wish.realisations ? ": give more in [accuracy] realisations"
                                              : ": give a larger bound, or more in [accuracy] realisations");
    }
    if (split.spectrum <= split.interpolation) return between_texels(settled, end);
    if (!std::holds_alternative<Palette>(job.material.mechanism))
        return integration_text(job) + " cost " + error_text(split.spectrum) +
               (settled.lut.wish.nodes ? ": leave nodes out, or give more" : ": give a larger bound");
    return "the fast integral costs " + error_text(split.spectrum) + ": use integral = \"exact\"";
}

}  // namespace nacre
