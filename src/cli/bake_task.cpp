#include "cli/bake_task.h"

#include <algorithm>
#include <cstdio>

#include "cli/report.h"
#include "cli/stop_signal.h"
#include "cli/swatch_file.h"
#include "cli/thread_clock.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

// Nothing is written that is there already.
void put(const BakeTarget& target, const std::string& name, std::string_view bytes, bool& unchanged) {
    if (!target.force && target.folder.holds(name, bytes)) return;
    unchanged = false;
    target.folder.write(name, bytes);
}

// "dE00 0.021 of 0.1".
std::string accuracy_text(const PlannedLut& lut, const BakedLut& baked) {
    if (!baked.reached) return "dE00 unknown";
    return "dE00 " + short_number(*baked.reached) + (lut.wish.has_bound ? " of " + number_text(lut.wish.max_de00) : "");
}

std::string lut_line(const BakeTask& task, const BakedLut& baked) {
    const PlannedLut& lut = task.settled->lut.lut;
    std::string line = output_files(lut).front() + "  " + size_text(lut.job) + " " +
                       std::string(name_of(format_words, lut.format)) + "  " + task.scene->transform.target() + "  " +
                       accuracy_text(lut, baked);
    if (baked.gamut.outside > 0) {
        const Gamut rule = task.scene->plan.colour.gamut;
        line += "  " + std::to_string(baked.gamut.outside) + " of " + std::to_string(baked.image.size()) +
                " texels out of gamut by up to " + short_number(-baked.gamut.most_negative) + ", " +
                (rule == Gamut::keep   ? "kept"
                 : rule == Gamut::clip ? "clipped"
                                       : "compressed");
    }
    const auto add_angle = [&](const char* text, double angle_deg) {
        char angle[64];
        std::snprintf(angle, sizeof angle, text, angle_deg);
        line += angle;
    };
    for (const EffectChoice& choice : task.settled->lut.effects) {
        if (!choice.is_simulated && choice.is_measured)
            line +=
                "  without " + std::string(row_of(choice.effect).name) + " (" + short_number(choice.contribution) + ")";
    }
    if (baked.clamped.below_deg) add_angle("  clamped below %.1f deg", *baked.clamped.below_deg);
    if (baked.clamped.above_deg) add_angle("  clamped above %.1f deg", *baked.clamped.above_deg);
    return line;
}

// The files of a LUT, in the order in which the scene asks for them.
void put_files(const BakeTask& task, const std::string& exr, const std::string& manifest, const BakeTarget& target,
               bool& unchanged) {
    const PlannedLut& lut = task.settled->lut.lut;
    for (const LutOutput output : lut.outputs) {
        const std::string file = lut.name + "." + std::string(name_of(output_words, output));
        switch (output) {
            case LutOutput::exr:
                put(target, file, exr, unchanged);
                break;
            case LutOutput::json:
                put(target, file, manifest, unchanged);
                break;
            case LutOutput::png: {
                PlannedSwatch strip;
                strip.title = lut.name;
                strip.jobs = {lut.job};
                put(target, file, swatch_bytes(strip, task.scene->transform, *task.scene->strip_transform, target.font),
                    unchanged);
                break;
            }
        }
    }
}

bool writes(const PlannedLut& lut, LutOutput output) {
    return std::find(lut.outputs.begin(), lut.outputs.end(), output) != lut.outputs.end();
}

BakeOutcome bake_one_lut(const BakeTask& task, const BakeTarget& target) {
    const LoadedScene& scene = *task.scene;
    const SettledLut& settled = task.settled->lut;
    const double begin = thread_seconds();
    const BakedLut baked = bake_lut(settled, scene.plan, scene.source, scene.transform, throw_if_stopped);
    const std::string manifest = manifest_json(settled, baked);
    const std::string exr =
        writes(settled.lut, LutOutput::exr) ? encode_lut(baked.image, settled.lut.format, baked.header) : std::string();
    const double seconds = thread_seconds() - begin;

    BakeOutcome outcome;
    const double bound = settled.lut.wish.max_de00;
    outcome.misses_bound =
        settled.lut.wish.is_binding && !target.best_effort && baked.reached && !(*baked.reached <= bound);
    if (outcome.misses_bound) {
        outcome.failure = task.where().text() + " " + task.name() + ": errs by " + short_number(*baked.reached) +
                          " where max_de00 = " + number_text(bound) + " was promised; please report this scene";
        return outcome;
    }
    // A bound that nobody gave is a goal; that it is out of reach was said before, unless the plan did not see it.
    if (settled.lut.wish.has_bound && settled.is_reached && baked.reached && !(*baked.reached <= bound)) {
        outcome.warning = task.where().text() + " " + task.name() + ": errs by " + short_number(*baked.reached) +
                          ", more than max_de00 = " + number_text(bound) + "; please report this scene";
    }
    outcome.unchanged = true;
    put_files(task, exr, manifest, target, outcome.unchanged);
    outcome.outside_gamut = baked.gamut.outside;
    outcome.json = nlohmann::ordered_json::parse(manifest);
    outcome.json["unchanged"] = outcome.unchanged;
    outcome.json["seconds"] = {{"deciding", task.settled->seconds}, {"baking", seconds}};
    outcome.json["work"] = {{"deciding", work_json(settled.work)}, {"baking", work_json(baked.work)}};
    outcome.line = lut_line(task, baked) + (outcome.unchanged ? "  (unchanged)" : "");
    return outcome;
}

BakeOutcome bake_one_swatch(const BakeTask& task, const BakeTarget& target) {
    const PlannedSwatch& swatch = *task.swatch;
    const ColourTransform& transform = task.scene->swatch_transforms[task.swatch_index];
    BakeOutcome outcome;
    outcome.unchanged = true;
    put(target, swatch.name + ".png", swatch_bytes(swatch, task.scene->transform, transform, target.font),
        outcome.unchanged);
    outcome.line = swatch.name + ".png  " + std::string(name_of(swatch_words, swatch.kind)) + "  " +
                   transform.target() + (outcome.unchanged ? "  (unchanged)" : "");
    outcome.json = {{"file", swatch.name + ".png"},
                    {"draw", name_of(swatch_words, swatch.kind)},
                    {"display", transform.display()},
                    {"view", transform.view()},
                    {"unchanged", outcome.unchanged}};
    return outcome;
}

}  // namespace

bool BakeTask::draws_picture() const {
    return swatch != nullptr || writes(*lut, LutOutput::png);
}

BakeOutcome run_bake_task(const BakeTask& task, const BakeTarget& target) {
    BakeOutcome outcome;
    if (task.settled != nullptr && !task.settled->failure.empty()) {
        outcome.failure = task.settled->failure;
        return outcome;
    }
    try {
        return task.lut != nullptr ? bake_one_lut(task, target) : bake_one_swatch(task, target);
    } catch (const IoError&) {
        throw;  // the disk's refusal ends the batch; a LUT's own failure does not
    } catch (const Error& error) {
        outcome.failure = task.where().text() + " " + task.name() + ": " + error.what();
        return outcome;
    }
}

}  // namespace nacre
