#include "cli/bake_report.h"

#include <cmath>
#include <cstddef>

#include "cli/report.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/gamut.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

// "dE00 0.021 of 0.1".
std::string accuracy_text(const PlannedLut& lut, const BakedLut& baked) {
    if (!baked.reached) return "dE00 unknown";
    return "dE00 " + short_number(*baked.reached) +
           (lut.request.has_bound ? " of " + number_text(lut.request.max_de00) : "");
}

// "25 % of texels".
std::string share_text(std::size_t count, const Job& job) {
    const double texels = static_cast<double>(job.width) * job.height;
    return significant_text(100.0 * static_cast<double>(count) / texels, 2) + " % of texels";
}

// "25 % of texels are negative (minimum -0.060)", and what was done about it.
std::string gamut_text(const Job& job, const GamutReport& gamut, Gamut rule) {
    return share_text(gamut.outside, job) + " " + (rule == Gamut::keep ? "are" : "were") + " negative (minimum -" +
           short_number(-gamut.most_negative) + ")" +
           (rule == Gamut::clip       ? ", clipped"
            : rule == Gamut::compress ? ", compressed"
                                      : "");
}

std::string lut_line(const BakeTask& task, const BakedLut& baked) {
    const PlannedLut& lut = task.decided->lut.lut;
    std::string line = output_files(lut).front() + "  " + size_text(lut.job) + " " +
                       std::string(name_of(format_words, lut.format)) + "  " +
                       space_text(task.decided->space(), *task.scene) + "  " + accuracy_text(lut, baked);
    if (const std::string wide = width_text(lut.job); !wide.empty()) line += "  " + wide;
    if (baked.gamut.outside > 0) line += "  " + gamut_text(lut.job, baked.gamut, lut.colour.gamut);
    for (const EffectChoice& choice : task.decided->lut.effects) {
        if (!choice.is_simulated && choice.is_measured)
            line +=
                "  without " + std::string(row_of(choice.effect).name) + " (" + short_number(choice.contribution) + ")";
    }
    if (baked.clamped.below_deg) line += "  clamped below " + fixed_text(*baked.clamped.below_deg, 1) + " deg";
    if (baked.clamped.above_deg) line += "  clamped above " + fixed_text(*baked.clamped.above_deg, 1) + " deg";
    return line;
}

}  // namespace

std::string bake_line(const BakeTask& task, const BakeOutcome& outcome) {
    std::string line;
    if (task.is_lut()) {
        line = lut_line(task, outcome.baked);
        if (outcome.png_clamped.value_or(0) > 0) {
            line += "  " + share_text(*outcome.png_clamped, task.decided->lut.lut.job) + " clamped in " + task.name() +
                    ".png";
        }
    } else {
        line = task.picture() + "  " + std::string(name_of(swatch_words, task.draws())) + "  " + task.display->name();
    }
    return line + (outcome.unchanged ? "  (unchanged)" : "");
}

std::string gamut_warning(const BakeTask& task, const BakedLut& baked) {
    const PlannedLut& lut = task.decided->lut.lut;
    if (lut.colour.gamut != Gamut::keep || baked.gamut.outside == 0) return {};
    if (baked.clipping && baked.clipping->texels == 0) return {};
    const std::string& material = lut.job.material.name;
    std::string text = lut.name + (material == lut.name ? "" : " (material " + material + ")") + ": " +
                       share_text(baked.clipping ? baked.clipping->texels : baked.gamut.outside, lut.job) +
                       " have negative components, because the colour lies outside " + task.decided->space().name();
    if (baked.clipping)
        text += "; setting them to 0 would change it by up to dE00 " + short_number(baked.clipping->de00);
    return text;
}

Json bake_json(const BakeTask& task, const BakeOutcome& outcome) {
    if (!task.is_lut()) {
        Json json{{"file", task.picture()},
                  {"draw", name_of(swatch_words, task.draws())},
                  {"display", task.display->display()},
                  {"view", task.display->view()},
                  {"unchanged", outcome.unchanged}};
        if (task.kind == TaskKind::preview) json["lut"] = task.lut->name;
        return json;
    }
    Json json = outcome.manifest;
    if (outcome.png_clamped) json["png_clamped"] = *outcome.png_clamped;
    json["unchanged"] = outcome.unchanged;
    json["seconds"] = {{"deciding", task.decided->seconds},
                       {"computing", outcome.baked.computing_seconds},
                       {"measuring", outcome.baked.measuring_seconds},
                       {"baking", outcome.seconds}};
    json["work"] = {{"deciding", work_json(task.decided->lut.work)}, {"baking", work_json(outcome.baked.work)}};
    return json;
}

}  // namespace nacre
