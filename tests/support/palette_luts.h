#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "support/test_encoding.h"

namespace nacre {

/// How GoogleTest shows it.
inline void PrintTo(const Work& work, std::ostream* out) {
    *out << "{exact " << work.exact_integrals << ", spectra " << work.spectra << ", texels " << work.texels
         << ", probes " << work.probes << ", references " << work.references << '}';
}

}  // namespace nacre

/// Materials, lights and LUTs that the tests of accuracy share, and the plain way to find the error of a LUT.
namespace nacre::test {

/// The paper's Morpho.
inline const Palette morpho{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}, 0.26};
/// The paper's beetle. Beyond 60 degrees its height is clamped: a kink within the range.
inline const Palette beetle{{{10.0, {530.0, 110.0, 0.73}}, {60.0, {460.0, 110.0, 1.0}}}, 0.91};
/// Three picks through green, red and blue, one of them narrow.
inline const Palette opal{{{5.0, {640.0, 90.0, 0.8}}, {35.0, {545.0, 25.0, 0.9}}, {70.0, {450.0, 60.0, 0.5}}}};

inline std::shared_ptr<const Light> light_of(LightSettings settings) {
    settings.power = *illuminant_by_name(settings.illuminant);
    return std::make_shared<const Light>(make_light(std::move(settings)));
}
inline std::shared_ptr<const Light> light_of(const std::string& illuminant = "D65",
                                             std::optional<int> wavelengths = {}) {
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.wavelengths = wavelengths;
    return light_of(std::move(settings));
}

inline Job job_of(const Palette& palette, int width = 64) {
    Job job;
    job.material = {"material", palette, {}};
    job.light = light_of();
    job.width = width;
    return job;
}
/// The same over a second axis.
inline Job job_of(const Palette& palette, Axis y, int width, int height) {
    Job job = job_of(palette, width);
    job.y = std::move(y);
    job.height = height;
    return job;
}
/// Not over the angle, but over a parameter of the material; seen at one angle.
inline Job job_over(const Palette& palette, Axis x, double angle_deg, int width = 64) {
    Job job = job_of(palette, width);
    job.x = std::move(x);
    job.fixed = Incidence::from_degrees(angle_deg);
    return job;
}

inline const AxisKind& axis_kind(std::string_view name) {
    return *std::find_if(axis_kinds().begin(), axis_kinds().end(),
                         [&](const AxisKind& kind) { return kind.name == name; });
}

inline Image<Rgb> stored_lut(const Job& job, PixelFormat format) {
    return stored_as(rec709_encoding().to_rgb(bake(job)), format);
}

/// Linear filter as graphics interfaces specify it, by texture coordinates: the sample lies u * size - 0.5 texels from
/// the first one's centre, and neighbours beyond an edge are the edge (OpenGL 4.6, section 8.14.3).
inline Rgb sampled_as_in_opengl(const Image<Rgb>& lut, double u, double v) {
    const double i = u * lut.width() - 0.5;
    const double j = v * lut.height() - 0.5;
    const auto texel = [&](double column, double row) {
        return lut.at(std::clamp(static_cast<int>(column), 0, lut.width() - 1),
                      std::clamp(static_cast<int>(row), 0, lut.height() - 1));
    };
    Rgb sum;
    for (const int down : {0, 1}) {
        for (const int across : {0, 1}) {
            const double alpha = i - std::floor(i);
            const double beta = j - std::floor(j);
            const double share = (across == 1 ? alpha : 1.0 - alpha) * (down == 1 ? beta : 1.0 - beta);
            const Rgb neighbour = texel(std::floor(i) + across, std::floor(j) + down);
            sum = {sum.r + share * neighbour.r, sum.g + share * neighbour.g, sum.b + share * neighbour.b};
        }
    }
    return sum;
}

/// CIEDE2000 of two XYZ, both shown at a scale.
inline double shown_difference(Xyz one, Xyz other, double scale) {
    const auto lab = [&](Xyz colour) {
        return to_lab({scale * colour.x, scale * colour.y, scale * colour.z}, d65_white);
    };
    return ciede2000(lab(one), lab(other));
}

/// The scale at which the brightest of a LUT's exact texels has Y = 1.
inline double shown_scale(const Job& job) {
    double brightest = 0.0;
    for (const Xyz& texel : bake(job)) brightest = std::max(brightest, texel.y);
    return brightest > 0.0 ? 1.0 / brightest : 1.0;
}

/// Error of a LUT at one point.
inline double plain_error(const Job& job, const Image<Rgb>& stored, LutPoint point, double scale) {
    Image<Rgb> fetched(
        1, 1,
        sampled_as_in_opengl(stored, texcoord_of(point.x, stored.width()), texcoord_of(point.y, stored.height())));
    static const Encoding encoding = rec709_encoding();
    return shown_difference(encoding.to_xyz(fetched).at(0, 0), exact_xyz(job, point.x, point.y), scale);
}

/// The largest error of a LUT by looking everywhere: `per_cell` points for every step from one texel to the next, along
/// either axis.
inline double plain_largest_error(const Job& job, const Image<Rgb>& stored, int per_cell) {
    const double scale = shown_scale(job);
    const int columns = std::max((job.width - 1) * per_cell, 1);
    const int rows = (job.height - 1) * per_cell;
    double largest = 0.0;
    for (int j = 0; j <= rows; ++j) {
        const double y = rows == 0 ? 0.0 : static_cast<double>(j) / rows;
        for (int i = 0; i <= columns; ++i)
            largest = std::max(largest, plain_error(job, stored, {static_cast<double>(i) / columns, y}, scale));
    }
    return largest;
}

/// What of a computation a plan predicts: all but the work of each effect, which is counted only.
inline Work without_effects(Work work) {
    work.effects = {};
    return work;
}

/// A LUT that leaves its size open.
inline PlannedLut requested_lut(Job job, double max_de00) {
    PlannedLut lut;
    lut.name = "lut";
    lut.job = std::move(job);
    lut.request.max_de00 = max_de00;
    return lut;
}

}  // namespace nacre::test
