#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/effect_table.h"
#include "cli/found_report.h"
#include "cli/rehearsal.h"
#include "cli/report.h"
#include "cli/settled_luts.h"
#include "cli/stop_signal.h"
#include "cli/text_table.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/shade/integral.h"

namespace nacre {
namespace {

struct PlanOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> only;
    std::string ocio;
    double accuracy = 0.0;
    std::string effects;
    int threads = 0;
    bool strict = false;
};

std::string axis_text(const Axis& axis) {
    if (axis.is_angle()) return std::string(axis.kind->name);
    return axis.parameter.name + " " + number_text(axis.from) + " to " + number_text(axis.to);
}

std::string bound_text(const SettledLut& settled) {
    if (!settled.lut.wish.has_bound) return short_number(settled.predicted.total);
    return short_number(settled.predicted.total) + " of " + number_text(settled.lut.wish.max_de00);
}

const std::vector<std::string> heading{"LUT", "axes", "texels", "format", "integral", "expected dE00", "bake time"};
const std::vector<bool> right_aligned{false, false, true, false, false, true, true};

std::vector<std::string> table_row(const SettledTask& task, double seconds) {
    const SettledLut& settled = task.lut;
    const Job& job = settled.lut.job;
    return {settled.lut.name,      axis_text(job.x) + (job.y ? ", " + axis_text(*job.y) : ""),
            size_text(job),        std::string(name_of(format_words, settled.lut.format)),
            integration_text(job), task.scene->transform.has_way_back() ? bound_text(settled) : "unknown",
            duration_text(seconds)};
}

// "errors of morpho: interpolation 0.089, storage 0.032", the largest first.
std::vector<std::string> error_lines(const SettledTask& task) {
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

nlohmann::ordered_json axis_json(const Axis& axis) {
    if (axis.is_angle()) return {{"axis", axis.kind->name}};
    return {{"parameter", axis.parameter.name}, {"from", axis.from}, {"to", axis.to}};
}

// The fitted shape of a palette, and what the paper's straight lines would make of each pick.
nlohmann::ordered_json shape_json(const SceneMaterial& material) {
    nlohmann::ordered_json json{{"shape", material.shape_fit->shape}};
    const auto& picks = std::get<Palette>(material.mechanism).picks;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        json["picks"].push_back(
            {{"pick", i}, {"angle_deg", picks[i].angle_deg}, {"straight_line_de00", material.shape_fit->de00[i]}});
    }
    return json;
}

nlohmann::ordered_json task_json(const SettledTask& task, double seconds) {
    const SettledLut& settled = task.lut;
    const PlannedLut& lut = settled.lut;
    const Job& job = lut.job;
    nlohmann::ordered_json json{{"scene", task.scene->path}, {"lut", lut.name}, {"material", job.material.name}};
    json["mechanism"] = mechanism_name(job.material.mechanism);
    json["x"] = axis_json(job.x);
    if (job.y) json["y"] = axis_json(*job.y);
    json["width"] = job.width;
    json["height"] = job.height;
    json["format"] = name_of(format_words, lut.format);
    json["wavelengths"] = nullptr;
    if (job.light->settings.wavelengths) {
        json["wavelengths"] = *job.light->settings.wavelengths;
    } else if (std::holds_alternative<Palette>(job.material.mechanism)) {
        json["integral"] = name_of(integral_words, job.integral);
    } else if (samples_spectra(job.material.mechanism)) {
        json["nodes"] = job.sampling.node_counts();
    }
    if (job.sampling.realisations > 1) json["realisations"] = job.sampling.realisations;
    if (std::holds_alternative<Crystal>(job.material.mechanism)) json["slices"] = job.sampling.slices;
    const EffectSet effects = effects_in(job);
    if (effects.has(Effect::base) && !job.without.has(Effect::base) && is_layered(job.material.mechanism))
        json["base_directions"] = job.sampling.hemisphere;
    if (job.sampling.sizes > 1) json["radii"] = job.sampling.sizes;
    const SceneMaterial* material = find_material(task.scene->plan, job.material.name);
    if (material != nullptr) {
        for (const PickedColour& picked : material->picked) json["picked"].push_back(picked_json(picked));
    }
    for (const MaterialSearch& search : task.scene->plan.searches) {
        if (search.material == job.material.name && !search.search.free.empty()) json["found"] = found_json(search);
    }
    if (material != nullptr && material->shape_fit) json["shape_fit"] = shape_json(*material);
    json["max_de00"] = nullptr;
    if (lut.wish.has_bound) json["max_de00"] = lut.wish.max_de00;
    json["predicted"] = nullptr;
    if (task.scene->transform.has_way_back()) {
        json["predicted"] = {{"de00", settled.predicted.total},      {"spectrum", settled.predicted.spectrum},
                             {"spread", settled.predicted.spread},   {"quadrature", settled.predicted.quadrature},
                             {"effects", settled.predicted.effects}, {"interpolation", settled.predicted.interpolation},
                             {"storage", settled.predicted.storage}};
    }
    json["reached"] = settled.is_reached || !lut.wish.has_bound;
    if (!settled.obstacle.empty()) json["obstacle"] = settled.obstacle;
    json["seconds"] = {{"deciding", task.seconds}, {"baking", seconds}};
    json["work"] = {{"deciding", work_json(settled.work)}, {"baking", work_json(bake_work(job, settled.worst.size()))}};
    json["files"] = output_files(lut);
    return json;
}

// What picked colours became.
void note_picked(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        for (const PickedColour& picked : material.picked) {
            std::string band;
            if (picked.lobe) {
                band = " is the band peak_nm = " + significant_text(picked.lobe->peak_nm, 6) +
                       ", width_nm = " + significant_text(picked.lobe->width_nm, 6) +
                       ", height = " + significant_text(picked.lobe->height, 4) + ",";
            }
            console.summary(material.name + ": " + picked.text + " at " + number_text(picked.angle_deg) + " deg" +
                            band + (picked.lobe ? " " : ": ") + match_text(picked));
        }
    }
    for (const MaterialSearch& search : scene.plan.searches) {
        if (search.search.free.empty()) continue;
        for (std::size_t i = 0; i < search.found.size(); ++i)
            console.summary(search.material + ": " + (i == 0 ? "found " : "or    ") + answer_text(search, i));
    }
}

// What the picks say about the shape that the scene left open.
void note_shapes(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        if (!material.shape_fit) continue;
        const auto& picks = std::get<Palette>(material.mechanism).picks;
        std::string misses;
        for (std::size_t i = 0; i < picks.size(); ++i) {
            misses += (i == 0 ? "" : ", ") + significant_text(material.shape_fit->de00[i], 2) + " at " +
                      number_text(picks[i].angle_deg) + " deg";
        }
        console.summary(material.name + ": shape = " + number_text(material.shape_fit->shape) +
                        " is nearest to its picks; straight lines would miss them by CIEDE2000 " + misses);
    }
}

// What a scene's picks ask for that no surface can do.
void note_clamps(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        const auto* palette = std::get_if<Palette>(&material.mechanism);
        if (palette == nullptr) continue;
        const ClampBounds bounds = palette_clamp_bounds(*palette);
        const auto note = [&](const char* side, const std::optional<double>& angle_deg) {
            if (!angle_deg) return;
            console.summary(material.name + ": clamped " + side + " " + short_number(*angle_deg) +
                            " deg, where its picks lead to a reflectance outside 0 to 1, or a width below 0");
        };
        note("below", bounds.below_deg);
        note("above", bounds.above_deg);
    }
}

// What measurements do not say, and how it is filled in.
void note_edges(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        const auto* spectra = std::get_if<MeasuredSpectra>(&material.mechanism);
        if (spectra == nullptr) continue;
        const auto range = [](double first, double last) { return number_text(first) + " to " + number_text(last); };
        console.summary(material.name + ": measured from " +
                        range(spectra->wavelength_nm.front(), spectra->wavelength_nm.back()) + " nm and " +
                        range(spectra->angle_deg.front(), spectra->angle_deg.back()) +
                        " deg; beyond, the nearest measurement is held");
    }
}

std::vector<SettledTask> list_luts(const std::vector<LoadedScene>& scenes) {
    std::vector<SettledTask> tasks;
    for (const LoadedScene& scene : scenes) {
        for (const PlannedLut& lut : scene.plan.luts) {
            SettledTask& task = tasks.emplace_back();
            task.scene = &scene;
            task.asked = &lut;
        }
    }
    return tasks;
}

int run_plan(const PlanOptions& options, Console& console) {
    std::vector<LoadedScene> scenes =
        load_scenes(options.scenes, options.ocio, true, options.only, options.strict, console);
    override_accuracy(scenes, options.accuracy, options.effects);
    std::vector<SettledTask> tasks = list_luts(scenes);
    settle_all(tasks, options.threads, console);
    std::vector<std::vector<std::string>> rows{heading};
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    std::vector<std::string> effect_text;
    bool any_failed = false;
    prepare_encoder();
    for (const SettledTask& task : tasks) {
        throw_if_stopped();
        if (!task.failure.empty()) {
            console.error(task.failure);
            any_failed = true;
            continue;
        }
        const double seconds = rehearse(task);
        const std::vector<EffectShare> effects = effect_shares(task.lut);
        rows.push_back(table_row(task, seconds));
        json.push_back(task_json(task, seconds));
        json.back()["effects"] = effects_json(effects);
        if (task.scene->transform.has_way_back()) {
            for (std::string& line : error_lines(task)) effect_text.push_back(std::move(line));
        }
        for (std::string& line : effect_lines(task.lut.lut.name, effects)) effect_text.push_back(std::move(line));
        effect_text.emplace_back();
    }
    for (const std::string& line : table_lines(rows, right_aligned)) console.summary(line);
    console.summary("");
    for (const std::string& line : effect_text) console.summary(line);
    for (const LoadedScene& scene : scenes) {
        note_picked(scene, console);
        note_shapes(scene, console);
        note_clamps(scene, console);
        note_edges(scene, console);
        for (const PlannedSwatch& swatch : scene.plan.swatches)
            console.summary(swatch.name + ".png: " + std::string(name_of(swatch_words, swatch.kind)));
    }
    if (console.json()) console.result_json({{"luts", json}});
    if (report_out_of_reach(tasks, false, console) > 0) return exit_not_verified;
    return any_failed ? exit_some_failed : exit_done;
}

}  // namespace

Command add_plan_command(CLI::App& app) {
    const auto options = std::make_shared<PlanOptions>();
    app.add_option("SCENE", options->scenes, "scene files (TOML)")->required()->type_name("");
    add_accuracy_option(app, options->accuracy);
    add_effects_option(app, options->effects);
    app.add_option("--only", options->only, "only the LUT or swatch of this name; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--ocio", options->ocio, "OpenColorIO config; wins over the scene's, which wins over $OCIO")
        ->type_name("FILE");
    app.add_option("--threads", options->threads, "threads at once; 0: one per core")
        ->type_name("N")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    add_strict_option(app, options->strict);
    app.footer(
        "\nPer LUT: axes, size, format, how spectra become colour; the error to expect (CIEDE2000, the largest over "
        "the\n"
        "LUT); the time that one thread of this machine needs. Then what has a part in that error, the largest first.\n"
        "Then its effects, the dearest first: simulated, or negligible here, by what leaving them out would change; "
        "and\n"
        "their share of the time.\n"
        "Writes nothing. Exit code 4 if a bound that you gave is out of reach.\n\nExample:\n"
        "  nacre plan configs/scenes/morpho.toml --accuracy 0.5\n");
    return [options](Console& console) { return run_plan(*options, console); };
}

}  // namespace nacre
