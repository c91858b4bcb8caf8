#include "cli/rehearsal.h"

#include <algorithm>
#include <chrono>

namespace nacre {
namespace {

constexpr int most_texels = 4096;

// Of three: the first finds cold caches, one may be interrupted.
double seconds_of(const SettledLut& lut, const LoadedScene& scene) {
    double best = 0.0;
    for (int run = 0; run < 3; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const BakedLut baked = bake_lut(lut, scene.plan.colour, scene.source, scene.transform);
        const auto bytes = encode_lut(baked.image, lut.lut.format, baked.header).size() + manifest_json(lut, baked).size();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (bytes > 0 && (run == 0 || seconds < best)) best = seconds;
    }
    return best;
}

}  // namespace

double rehearse(const SettledTask& task) {
    SettledLut sample = task.lut;
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
