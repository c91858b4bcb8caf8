#include "pipeline/bake_task.h"

#include <algorithm>
#include <atomic>
#include <string_view>

#include "io/image/lut_file.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "pipeline/manifest.h"
#include "pipeline/swatch_file.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// Files that are made durable together: one flush of the disk for so many, and never more of them half-way.
constexpr std::size_t files_per_commit = 512;

// Digits of an error in messages.
constexpr int error_digits = 2;

// Nothing is written that is there already.
void put(const BakeTarget& target, const std::string& name, std::string_view bytes, bool& unchanged) {
    if (!target.force && target.folder.holds(name, bytes)) return;
    unchanged = false;
    target.folder.write(name, bytes);
}

std::string strip_bytes(const BakeTask& task, const BakeTarget& target) {
    PlannedSwatch strip;
    strip.title = task.decided->lut.lut.name;
    strip.jobs = {task.decided->lut.lut.job};
    return swatch_bytes(strip, task.decided->space(), *task.scene->strip_display, target.font);
}

// The files of a LUT, in the order in which the scene asks for them.
void put_files(const BakeTask& task, const std::string& exr, const std::string& manifest, const BakeTarget& target,
               bool& unchanged) {
    const PlannedLut& lut = task.decided->lut.lut;
    for (const LutOutput output : lut.outputs) {
        const std::string file = lut.name + "." + std::string(name_of(output_words, output));
        switch (output) {
            case LutOutput::exr:
                put(target, file, exr, unchanged);
                break;
            case LutOutput::json:
                put(target, file, manifest, unchanged);
                break;
            case LutOutput::png:
                put(target, file, strip_bytes(task, target), unchanged);
                break;
        }
    }
}

bool writes(const PlannedLut& lut, LutOutput output) {
    return std::find(lut.outputs.begin(), lut.outputs.end(), output) != lut.outputs.end();
}

// What the measured error says about the bound, in the outcome's words.
void judge_bound(const BakeTask& task, const BakeTarget& target, BakeOutcome& outcome) {
    const ChosenLut& decided = task.decided->lut;
    const AccuracyRequest& request = decided.lut.request;
    if (!outcome.baked.reached || *outcome.baked.reached <= request.max_de00) return;
    const std::string error = task.where().text() + " " + task.name() + ": has an error of " +
                              significant_text(*outcome.baked.reached, error_digits);
    if (request.is_binding && !target.best_effort) {
        outcome.misses_bound = true;
        outcome.failure = error + ", more than the promised max_de00 = " + number_text(request.max_de00) +
                          "; please report this scene";
    } else if (request.has_bound && decided.is_reached) {
        // A bound that nobody gave is a goal; that it is out of reach was said before, unless the plan did not see it.
        outcome.warning =
            error + ", more than max_de00 = " + number_text(request.max_de00) + "; please report this scene";
    }
}

BakeOutcome bake_one_lut(const BakeTask& task, const BakeTarget& target, const Execution& execution) {
    const LoadedScene& scene = *task.scene;
    const ChosenLut& decided = task.decided->lut;
    const double begin = thread_seconds();
    BakeOutcome outcome;
    outcome.baked = bake_lut(decided, scene.plan, scene.source, task.decided->space(), execution.step);
    outcome.manifest = manifest_json(decided, outcome.baked);
    const std::string manifest = outcome.manifest.text() + "\n";
    const std::string exr = writes(decided.lut, LutOutput::exr)
                                ? encode_lut(outcome.baked.image, decided.lut.format, outcome.baked.header)
                                : std::string();
    outcome.seconds = thread_seconds() - begin;
    outcome.baked.image = {};
    outcome.baked.header = {};
    judge_bound(task, target, outcome);
    if (!outcome.failure.empty()) return outcome;
    outcome.unchanged = true;
    put_files(task, exr, manifest, target, outcome.unchanged);
    return outcome;
}

BakeOutcome bake_one_swatch(const BakeTask& task, const BakeTarget& target) {
    BakeOutcome outcome;
    outcome.unchanged = true;
    put(target, task.swatch->name + ".png",
        swatch_bytes(*task.swatch, task.scene->space_of(task.swatch->colour), *task.scene->displays[task.swatch_index],
                     target.font),
        outcome.unchanged);
    return outcome;
}

}  // namespace

bool BakeTask::draws_picture() const {
    return swatch != nullptr || writes(*lut, LutOutput::png);
}

std::vector<BakeTask> bake_tasks(const std::vector<LoadedScene>& scenes, bool with_luts) {
    std::vector<BakeTask> tasks;
    for (const LoadedScene& scene : scenes) {
        if (with_luts) {
            for (const PlannedLut& lut : scene.plan.luts) tasks.push_back({&scene, &lut, nullptr, 0, nullptr});
        }
        for (std::size_t i = 0; i < scene.plan.swatches.size(); ++i)
            tasks.push_back({&scene, nullptr, &scene.plan.swatches[i], i, nullptr});
    }
    return tasks;
}

BakeOutcome run_bake_task(const BakeTask& task, const BakeTarget& target, const Execution& execution) {
    BakeOutcome outcome;
    if (task.decided != nullptr && !task.decided->failure.empty()) {
        outcome.failure = task.decided->failure;
        return outcome;
    }
    try {
        return task.lut != nullptr ? bake_one_lut(task, target, execution) : bake_one_swatch(task, target);
    } catch (const IoError&) {
        throw;  // the disk's refusal ends the batch; a LUT's own failure does not
    } catch (const Error& error) {
        outcome.failure = task.where().text() + " " + task.name() + ": " + error.what();
        return outcome;
    }
}

void bake_all(const std::vector<BakeTask>& tasks, const BakeTarget& target, const Execution& execution,
              const std::function<void(const BakeTask& task, const BakeOutcome& outcome)>& on_outcome) {
    prepare_encoder();
    std::atomic<std::size_t> done = 0;
    for (std::size_t begin = 0; begin < tasks.size(); begin += files_per_commit) {
        std::vector<BakeOutcome> outcomes(std::min(files_per_commit, tasks.size() - begin));
        execution.for_each(outcomes.size(), [&](std::size_t i) {
            execution.may_stop();
            outcomes[i] = run_bake_task(tasks[begin + i], target, execution);
            execution.tell(++done, tasks.size());
        });
        execution.may_stop();
        target.folder.commit();
        for (std::size_t i = 0; i < outcomes.size(); ++i) on_outcome(tasks[begin + i], outcomes[i]);
    }
}

}  // namespace nacre
