// What stands in the way of a bound, in one line.
//
// In: a LUT with the shares of its error. The factors are asked in the order in which a user can do something about
// them: effects that the scene itself leaves out, sums and formats, the colour space, the scene's wavelengths, samples
// of uneven thicknesses, and at last the nodes or the texels themselves. The first that dominates is named.
#include "nacre/accuracy/limiting_factor.h"

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

std::string angle_text(const Job& job, LutPoint at) {
    const Geometry geometry = geometry_at(job, at.x, at.y);
    switch (quantity_of(job.material.mechanism)) {
        case Quantity::incidence:
            return significant_text(geometry.incidence.theta_deg, 3) + " degrees";
        case Quantity::grating_u:
            return "u = " + significant_text(geometry.grating_u, 3);
        case Quantity::cos_scatter:
            return "cos = " + significant_text(geometry.cos_scatter, 3);
    }
    return {};
}

std::string between_texels(const ChosenLut& chosen, const SearchEnd& end) {
    const Job& job = chosen.lut.job;
    const AccuracyRequest& request = chosen.lut.request;
    std::string text =
        "interpolation between " + size_text(job) + " texels costs " + error_text(chosen.predicted.interpolation);
    if (end.is_effort_spent) return text + ", and trying more would take too long: give a larger bound, or size";
    if (request.width || (job.y && request.height)) return text + ": leave size out, or give a larger one";
    text += ", and " + std::to_string(end.most_texels) + " texels are the most that nacre tries: give a larger bound";
    return job.y ? text + ", or size" : text;
}

// A mean or sum that is too rough: where it can be set, and whether the scene sets it.
std::string of_sums(const ChosenLut& chosen) {
    const SamplingCounts& given = chosen.lut.request.sampling;
    const bool is_given = given.base_directions > 0 || given.radii > 0 || given.slices > 0;
    return "sums over base, radii or slices cost " + error_text(chosen.predicted.quadrature) +
           (is_given ? ": raise their counts in [accuracy.sampling], or remove them" : ": give a larger bound");
}

std::string of_thickness_samples(const ChosenLut& chosen) {
    const bool is_given = chosen.lut.request.sampling.thickness_samples > 0;
    return std::to_string(chosen.lut.job.sampling.thickness_samples) + " samples of uneven thicknesses cost " +
           error_text(chosen.predicted.spread) +
           (is_given ? ": give more in [accuracy.sampling] thickness_samples"
                     : ": give a larger bound, or more in [accuracy.sampling] thickness_samples");
}

std::string of_format(const ChosenLut& chosen) {
    const bool is_half = chosen.lut.format == PixelFormat::half_float;
    return (is_half ? "half costs " : "float costs ") + error_text(chosen.predicted.storage) +
           (is_half ? ": use float" : ": give a larger bound");
}

// "thickness_nm = 0, 90 degrees".
std::string place_text(const Job& job, LutPoint at) {
    std::string text;
    const auto add = [&](const Axis& axis, double coordinate) {
        if (!text.empty()) text += ", ";
        text += axis.is_angle() ? angle_text(job, at)
                                : axis.parameter.name + " = " + significant_text(axis.parameter_value(coordinate), 3);
    };
    add(job.x, at.x);
    if (job.y) add(*job.y, at.y);
    return text;
}

std::string of_jump(const Job& job, LutPoint at) {
    return "the colour jumps at " + place_text(job, at) +
           ", which no texture can hold: let the axis begin or end beside it, or give a larger bound";
}

std::string of_nodes(const ChosenLut& chosen) {
    const bool is_given = chosen.lut.request.sampling.nodes.front() > 0;
    return integration_text(chosen.lut.job) + " cost " + error_text(chosen.predicted.spectrum) +
           (is_given ? ": remove [accuracy.sampling] nodes, or give more" : ": give a larger bound");
}

}  // namespace

std::string limiting_factor(const ChosenLut& chosen, const Measured& measured) {
    if (measured.of_model <= 0.5 * measured.reached) {
        return "between its " + size_text(chosen.lut.job) + " texels it errs by " + error_text(measured.of_texels) +
               ": give a larger bound";
    }
    return "its colours, at " + integration_text(chosen.lut.job) + ", are off by " + error_text(measured.of_model) +
           " from an independent integral: give a larger bound, or more in [accuracy.sampling]";
}

std::string limiting_factor(const ChosenLut& chosen, const SearchEnd& end) {
    const ErrorSplit& split = chosen.predicted;
    if (end.jump) return of_jump(chosen.lut.job, *end.jump);
    if (split.effects > 0.5 * chosen.lut.request.max_de00) {
        return "effects that the scene leaves out cost " + error_text(split.effects) +
               ": remove them from [accuracy] without";
    }
    if (split.quadrature > std::max({split.interpolation, split.spectrum, split.storage, split.spread}))
        return of_sums(chosen);
    if (split.storage > std::max({split.interpolation, split.spectrum, split.spread})) return of_format(chosen);
    if (end.lost_by_space > 0.5 * split.total) {
        return "the round trip through the colour space costs " + error_text(end.lost_by_space) +
               ": use another space, or gamut = \"clip\" or \"compress\"";
    }
    const auto& wavelengths = chosen.lut.job.light->settings.wavelengths;
    if (wavelengths && split.spectrum > 0.5 * split.interpolation) {
        return std::to_string(*wavelengths) + " wavelengths cost " + error_text(split.spectrum) +
               ": leave wavelengths out";
    }
    if (split.spread > split.interpolation) return of_thickness_samples(chosen);
    return split.spectrum > split.interpolation ? of_nodes(chosen) : between_texels(chosen, end);
}

}  // namespace nacre
