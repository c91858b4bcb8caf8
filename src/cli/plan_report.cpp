#include "cli/plan_report.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>

#include "cli/effect_table.h"
#include "cli/found_report.h"
#include "cli/report.h"
#include "cli/text_table.h"
#include "nacre/accuracy/measure.h"
#include "nacre/base/text.h"
#include "nacre/base/words.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/plan.h"
#include "pipeline/manifest.h"

namespace nacre {
namespace {

std::string axis_text(const Axis& axis) {
    if (axis.is_angle()) return std::string(axis.kind->name);
    return axis.parameter.name + " " + number_text(axis.from) + " to " + number_text(axis.to);
}

std::string bound_text(const ChosenLut& chosen) {
    if (!chosen.lut.request.has_bound) return short_number(chosen.predicted.total);
    return short_number(chosen.predicted.total) + " of " + number_text(chosen.lut.request.max_de00);
}

// The fitted shape of a palette, and what the paper's straight lines would make of each pick.
Json shape_json(const SceneMaterial& material) {
    Json json{{"shape", material.shape_fit->shape}};
    const auto& picks = std::get<Palette>(material.mechanism).picks;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        json["picks"].push_back(
            Json{{"pick", i}, {"angle_deg", picks[i].angle_deg}, {"straight_line_de00", material.shape_fit->de00[i]}});
    }
    return json;
}

void add_sampling(Json& json, const Job& job) {
    json["wavelengths"] = Json();
    if (job.light->settings.wavelengths) {
        json["wavelengths"] = *job.light->settings.wavelengths;
    } else if (samples_spectra(job.material.mechanism)) {
        json["nodes"] = job.sampling.counts().nodes;
    }
    if (job.sampling.thickness_samples > 1) json["thickness_samples"] = job.sampling.thickness_samples;
    if (std::holds_alternative<Crystal>(job.material.mechanism)) json["slices"] = job.sampling.slices;
    const EffectSet effects = effects_in(job);
    if (effects.has(Effect::base) && !job.without.has(Effect::base) && is_layered(job.material.mechanism))
        json["base_directions"] = job.sampling.base_directions;
    if (job.sampling.radii > 1) json["radii"] = job.sampling.radii;
}

void add_picks(Json& json, const Plan& plan, const std::string& name) {
    const SceneMaterial* material = find_material(plan, name);
    if (material != nullptr) {
        for (const PickedColour& picked : material->picked) json["picked"].push_back(picked_json(picked));
    }
    for (const MaterialSearch& search : plan.searches) {
        if (search.material == name && !search.search.free.empty()) json["found"] = found_json(search);
    }
    if (material != nullptr && material->shape_fit) json["shape_fit"] = shape_json(*material);
}

void add_accuracy(Json& json, const DecidedLut& task) {
    const ChosenLut& chosen = task.lut;
    const AccuracyRequest& request = chosen.lut.request;
    json["max_de00"] = request.has_bound ? Json(request.max_de00) : Json();
    json["predicted"] = Json();
    if (task.space().has_inverse()) {
        json["predicted"] = {{"de00", chosen.predicted.total},      {"spectrum", chosen.predicted.spectrum},
                             {"spread", chosen.predicted.spread},   {"quadrature", chosen.predicted.quadrature},
                             {"effects", chosen.predicted.effects}, {"interpolation", chosen.predicted.interpolation},
                             {"storage", chosen.predicted.storage}};
    }
    json["reached"] = chosen.is_reached || !request.has_bound;
    if (!chosen.limiting_factor.empty()) json["limiting_factor"] = chosen.limiting_factor;
}

}  // namespace

std::vector<std::string> plan_lines(const std::vector<PlanRow>& rows) {
    std::vector<std::vector<std::string>> cells{
        {"LUT", "axes", "texels", "format", "integral", "expected dE00", "bake time", "space"}};
    for (const PlanRow& row : rows) {
        const ChosenLut& chosen = row.lut->lut;
        const Job& job = chosen.lut.job;
        const std::string quantity = is_transmittance(job.material.mechanism) ? "transmittance, " : "";
        cells.push_back({chosen.lut.name, quantity + axis_text(job.x) + (job.y ? ", " + axis_text(*job.y) : ""),
                         size_text(job), std::string(name_of(format_words, chosen.lut.format)), integration_text(job),
                         row.lut->space().has_inverse() ? bound_text(chosen) : "unknown", duration_text(row.seconds),
                         space_text(row.lut->space(), *row.lut->scene)});
    }
    return table_lines(cells, {false, false, true, false, false, true, true, false});
}

// "errors of morpho: interpolation 0.089, storage 0.032", the largest first.
std::vector<std::string> error_lines(const DecidedLut& task) {
    const ErrorSplit& split = task.lut.predicted;
    std::vector<std::pair<double, std::string_view>> parts{{split.spectrum, "spectrum"},
                                                           {split.spread, "spread of thicknesses"},
                                                           {split.quadrature, "base, radii, slices"},
                                                           {split.effects, "effects left out"},
                                                           {split.interpolation, "interpolation"},
                                                           {split.storage, "storage"}};
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& one, const auto& other) { return one.first > other.first; });
    constexpr std::size_t most_columns = 100;
    std::vector<std::string> lines{"errors of " + task.lut.lut.name + ":"};
    bool any = false;
    for (const auto& [error, name] : parts) {
        if (!(error > 0.0)) continue;
        const std::string text = std::string(name) + " " + short_number(error);
        if (any) lines.back() += ",";
        if (lines.back().size() + 2 + text.size() > most_columns) lines.emplace_back("   ");
        lines.back() += " " + text;
        any = true;
    }
    if (!any) lines.back() += " none";
    return lines;
}

Json plan_json(const PlanRow& row) {
    const DecidedLut& task = *row.lut;
    const ChosenLut& chosen = task.lut;
    const PlannedLut& lut = chosen.lut;
    const Job& job = lut.job;
    Json json{{"scene", task.scene->path}, {"lut", lut.name}, {"material", job.material.name}};
    json["mechanism"] = mechanism_name(job.material.mechanism);
    if (is_transmittance(job.material.mechanism)) json["quantity"] = "transmittance";
    json["x"] = axis_json(job.x);
    if (job.y) json["y"] = axis_json(*job.y);
    json["width"] = job.width;
    json["height"] = job.height;
    json["format"] = name_of(format_words, lut.format);
    json["colour_space"] = task.space().name();
    json["colour_config"] = task.scene->source.config;
    add_sampling(json, job);
    add_picks(json, task.scene->plan, job.material.name);
    add_accuracy(json, task);
    json["seconds"] = {{"deciding", task.seconds}, {"baking", row.seconds}};
    json["work"] = {{"deciding", work_json(chosen.work)}, {"baking", work_json(bake_work(job, chosen.worst.size()))}};
    json["files"] = output_files(lut);
    if (lut.preview != Preview::none) json["files"].push_back(preview_file(lut));
    json["effects"] = effects_json(row.effects);
    return json;
}

}  // namespace nacre
