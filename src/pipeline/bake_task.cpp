#include "pipeline/bake_task.h"

#include <algorithm>
#include <atomic>
#include <string_view>
#include <utility>

#include "io/image/lut_file.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/limiting_factor.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/scene/output_names.h"
#include "pipeline/bake_within_bound.h"
#include "pipeline/baked_lut.h"
#include "pipeline/lut_png.h"
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

// A file of a LUT, by the ending of its name.
std::string lut_file(const BakeTask& task, LutOutput output, BakeOutcome& outcome) {
    const ChosenLut& decided = task.decided->lut;
    switch (output) {
        case LutOutput::exr:
            return encode_lut(outcome.baked.image, decided.lut.format, outcome.baked.header);
        case LutOutput::json:
            return outcome.manifest.text() + "\n";
        case LutOutput::png: {
            LutPng png = lut_png(outcome.baked.image, task.decided->space(), *task.scene->default_display);
            outcome.png_clamped = png.clamped;
            return std::move(png.bytes);
        }
    }
    return {};
}

// What the measured error says about the bound, in the outcome's words.
void judge_bound(const BakeTask& task, const BakeTarget& target, BakeOutcome& outcome) {
    const ChosenLut& decided = task.decided->lut;
    const AccuracyRequest& request = decided.lut.request;
    if (!outcome.baked.reached || *outcome.baked.reached <= request.max_de00) return;
    const std::string error = task.where().text() + " " + task.name() + ": has an error of " +
                              significant_text(*outcome.baked.reached, error_digits);
    const std::string why = ", and more care did not help: " + limiting_factor(decided, *outcome.baked.measured);
    if (request.is_binding && !target.best_effort) {
        outcome.misses_bound = true;
        outcome.failure = error + ", more than the promised max_de00 = " + number_text(request.max_de00) + why;
    } else if (request.has_bound && decided.is_reached) {
        // A bound that nobody gave is a goal; that it is out of reach was said before, unless the plan did not see it.
        outcome.warning = error + ", more than max_de00 = " + number_text(request.max_de00) + why;
    }
}

BakeOutcome bake_one_lut(const BakeTask& task, const BakeTarget& target, const Execution& execution) {
    const double begin = thread_seconds();
    BakeOutcome outcome;
    outcome.baked = bake_within_bound(*task.decided, execution);
    const ChosenLut& decided = task.decided->lut;
    outcome.manifest = manifest_json(decided, outcome.baked);
    std::vector<std::string> files;
    for (const LutOutput output : decided.lut.outputs) files.push_back(lut_file(task, output, outcome));
    outcome.seconds = thread_seconds() - begin;
    outcome.baked.image = {};
    outcome.baked.header = {};
    judge_bound(task, target, outcome);
    if (!outcome.failure.empty()) return outcome;
    outcome.unchanged = true;
    for (std::size_t i = 0; i < files.size(); ++i)
        put(target, decided.lut.name + "." + std::string(name_of(output_words, decided.lut.outputs[i])), files[i],
            outcome.unchanged);
    return outcome;
}

PlannedSwatch preview_of(const PlannedLut& lut) {
    PlannedSwatch preview;
    preview.kind = SwatchKind::preview;
    preview.title = lut.name;
    preview.jobs = {lut.job};
    preview.colour = lut.colour;
    return preview;
}

std::string picture_bytes(const BakeTask& task, const BakeTarget& target) {
    const PlannedSwatch picture = task.swatch != nullptr ? *task.swatch : preview_of(*task.lut);
    return swatch_bytes(picture, task.scene->space_of(picture.colour), *task.display, target.font);
}

// Whatever keeps a picture from being drawn, LUTs are baked.
BakeOutcome draw_picture(const BakeTask& task, const BakeTarget& target) {
    BakeOutcome outcome;
    std::string bytes;
    try {
        bytes = picture_bytes(task, target);
    } catch (const Error& error) {
        const std::string failure = task.where().text() + " " + task.picture() + ": " + error.what();
        outcome.is_left_out = task.is_automatic();
        outcome.is_refused = dynamic_cast<const IoError*>(&error) != nullptr;
        (outcome.is_left_out ? outcome.warning : outcome.failure) = failure;
        return outcome;
    }
    outcome.unchanged = true;
    put(target, task.picture(), bytes, outcome.unchanged);
    return outcome;
}

}  // namespace

std::string BakeTask::picture() const {
    return kind == TaskKind::preview ? preview_file(*lut) : output_files(*swatch).front();
}

std::vector<BakeTask> bake_tasks(const std::vector<LoadedScene>& scenes, bool with_luts) {
    std::vector<BakeTask> tasks;
    for (const LoadedScene& scene : scenes) {
        for (const PlannedLut& lut : scene.plan.luts) {
            if (with_luts) tasks.push_back({TaskKind::lut, &scene, &lut});
            if (lut.preview == Preview::none) continue;
            tasks.push_back({TaskKind::preview, &scene, &lut, nullptr, scene.default_display.get()});
        }
        for (std::size_t i = 0; i < scene.plan.swatches.size(); ++i)
            tasks.push_back({TaskKind::swatch, &scene, nullptr, &scene.plan.swatches[i], scene.displays[i].get()});
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
        return task.is_lut() ? bake_one_lut(task, target, execution) : draw_picture(task, target);
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
