#include "pipeline/rehearsal.h"

#include <algorithm>

#include "io/image/lut_file.h"
#include "pipeline/manifest.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

constexpr int most_texels = 32768;

// Once only: a bake finds the caches cold too, and so the first LUT of a plan takes as long as the first of a bake.
double seconds_of(const ChosenLut& lut, const LoadedScene& scene) {
    const double begin = thread_seconds();
    const BakedLut baked = bake_lut(lut, scene.plan, scene.source, scene.space_of(lut.lut.colour));
    const std::string exr = encode_lut(baked.image, lut.lut.format, baked.header);
    const std::string manifest = manifest_text(lut, baked);
    return thread_seconds() - begin;
}

}  // namespace

double rehearse(const DecidedLut& task) {
    ChosenLut sample = task.lut;
    Job& job = sample.lut.job;
    const double texels = static_cast<double>(job.width) * job.height;
    if (texels <= most_texels) return seconds_of(sample, *task.scene);
    const int full_height = job.height;
    job.height = std::clamp(most_texels / job.width, 2, full_height);
    const double some = seconds_of(sample, *task.scene);
    const double some_texels = static_cast<double>(job.width) * job.height;
    job.width = 2;
    job.height = 2;
    const double none = seconds_of(sample, *task.scene);
    return none + std::max(some - none, 0.0) * texels / some_texels;
}

}  // namespace nacre
