#include "pipeline/decide.h"

#include <atomic>
#include <cstddef>

#include "nacre/base/error.h"
#include "pipeline/baked_lut.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

void decide(DecidedLut& task, const Execution& execution) {
    const double begin = thread_seconds();
    try {
        task.lut = choose_lut(*task.asked, lut_encoding(task.space(), task.asked->colour.gamut), execution.step);
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        task.failure = task.asked->where.text() + " " + task.asked->name + ": " + error.what();
    }
    task.seconds = thread_seconds() - begin;
}

}  // namespace

bool DecidedLut::is_out_of_reach() const {
    return failure.empty() && !lut.is_reached && lut.lut.request.has_bound && space().has_inverse();
}

void override_accuracy(std::vector<LoadedScene>& scenes, const AccuracyOverride& accuracy) {
    for (LoadedScene& scene : scenes) {
        for (PlannedLut& lut : scene.plan.luts) {
            if (accuracy.may_drop_effects) lut.request.may_drop_effects = *accuracy.may_drop_effects;
            if (accuracy.max_de00) {
                lut.request.max_de00 = *accuracy.max_de00;
                lut.request.has_bound = true;
                lut.request.is_binding = true;
            }
            const ColourSpace& space = scene.space_of(lut.colour);
            if (!lut.request.is_binding || space.has_inverse()) continue;
            throw Error(lut.where.text() + " " + lut.name + ": space " + space.name() +
                        " has no inverse to XYZ, so no error can be measured in it; give [accuracy] size and no bound");
        }
    }
}

std::vector<DecidedLut> undecided_luts(const std::vector<LoadedScene>& scenes) {
    std::vector<DecidedLut> luts;
    for (const LoadedScene& scene : scenes) {
        for (const PlannedLut& lut : scene.plan.luts) {
            DecidedLut& next = luts.emplace_back();
            next.scene = &scene;
            next.asked = &lut;
        }
    }
    return luts;
}

void decide_all(std::vector<DecidedLut>& luts, const Execution& execution) {
    std::atomic<std::size_t> done = 0;
    execution.for_each(luts.size(), [&](std::size_t i) {
        execution.may_stop();
        decide(luts[i], execution);
        execution.tell(++done, luts.size());
    });
    execution.may_stop();
}

}  // namespace nacre
