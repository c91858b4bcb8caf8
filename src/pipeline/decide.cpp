#include "pipeline/decide.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <span>
#include <utility>

#include "nacre/accuracy/choose_pair.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "pipeline/baked_lut.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// A LUT of a pair and the other one, that of the reflectance first.
std::array<PlannedLut, 2> pair_of(const PlannedLut& lut) {
    std::array<PlannedLut, 2> pair{lut, lut};
    pair[0].job.material.mechanism.effects.observed = Observed::reflectance;
    pair[1].job.material.mechanism.effects.observed = Observed::transmittance;
    return pair;
}

std::size_t place_in_pair(const PlannedLut& lut) {
    return lut.job.material.mechanism.effects.observed == Observed::reflectance ? 0 : 1;
}

// Whether two LUTs are one pair: plans have them side by side.
bool are_a_pair(const DecidedLut& one, const DecidedLut& next) {
    return one.asked->is_of_pair && next.asked->is_of_pair && one.scene == next.scene &&
           place_in_pair(*one.asked) == 0 && place_in_pair(*next.asked) == 1 && one.asked->entry == next.asked->entry;
}

// Decides a LUT, or both of a pair. @param tasks  one LUT or the two of a pair
void decide(std::span<DecidedLut> tasks, const Execution& execution) {
    const double begin = thread_seconds();
    const DecidedLut& task = tasks.front();
    try {
        const Encoding encoding = lut_encoding(task.space(), task.asked->colour.gamut);
        if (!task.asked->is_of_pair) {
            tasks.front().lut = choose_lut(*task.asked, encoding, execution.step);
        } else {
            ChosenPair pair = choose_pair(pair_of(*task.asked), encoding, execution.step);
            for (DecidedLut& one : tasks) {
                one.lut = std::move(pair[place_in_pair(*one.asked)]);
                one.lut.lut.name = one.asked->name;
            }
        }
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        for (DecidedLut& one : tasks)
            one.failure = one.asked->where.text() + " " + one.asked->name + ": " + error.what();
    }
    for (DecidedLut& one : tasks) one.seconds = (thread_seconds() - begin) / static_cast<double>(tasks.size());
}

}  // namespace

bool DecidedLut::is_out_of_reach() const {
    return failure.empty() && !lut.is_reached && lut.lut.request.has_bound && space().has_inverse();
}

std::string out_of_reach(const ChosenLut& chosen) {
    const PlannedLut& lut = chosen.lut;
    return lut.where.text() + " " + lut.name + ": " + (lut.request.is_binding ? "" : "the default ") +
           "max_de00 = " + number_text(lut.request.max_de00) + " cannot be reached; the best is " +
           significant_text(chosen.predicted.total, 3) + ", with " + size_text(lut.job) + " " +
           std::string(name_of(format_words, lut.format)) + ": " + chosen.limiting_factor;
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
    std::vector<std::span<DecidedLut>> together;
    for (std::size_t i = 0; i < luts.size(); i += together.back().size())
        together.push_back(std::span(luts).subspan(i, i + 1 < luts.size() && are_a_pair(luts[i], luts[i + 1]) ? 2 : 1));
    std::atomic<std::size_t> done = 0;
    execution.for_each(together.size(), [&](std::size_t i) {
        execution.may_stop();
        decide(together[i], execution);
        execution.tell(done += together[i].size(), luts.size());
    });
    execution.may_stop();
}

}  // namespace nacre
