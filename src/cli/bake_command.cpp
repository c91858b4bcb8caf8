#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "cli/commands.h"
#include "cli/loaded_scene.h"
#include "cli/stop_signal.h"
#include "io/font.h"
#include "io/output_folder.h"
#include "io/swatch_png.h"
#include "nacre/bake/names.h"
#include "nacre/bake/output_names.h"
#include "nacre/bake/swatch.h"
#include "nacre/error.h"

namespace nacre {
namespace {

// Files that are made durable together: one flush of the disk for so many, and never more of them half-way.
constexpr std::size_t files_per_commit = 512;

// What the Color Interop Forum calls the encoding of an sRGB display.
constexpr std::string_view srgb_display_id = "srgb_rec709_display";

struct BakeOptions {
    std::vector<std::string> scenes;
    std::string folder = ".";
    std::vector<std::string> only;
    std::string ocio;
    std::string shard;
    int threads = 0;
    bool force = false;
    bool dry_run = false;
};

// One LUT or one swatch of one scene.
struct Task {
    const LoadedScene* scene;
    const PlannedLut* lut;        // null for a swatch
    const PlannedSwatch* swatch;  // null for a LUT
    std::size_t swatch_index;

    const std::string& name() const { return lut != nullptr ? lut->name : swatch->name; }
};

struct Outcome {
    std::string line;             // for people
    nlohmann::ordered_json json;  // for machines
    std::string failure;          // why it was not written; empty if it was
    std::size_t outside_gamut = 0;
    bool unchanged = false;
};

std::vector<Task> list_tasks(const std::vector<LoadedScene>& scenes, bool with_luts) {
    std::vector<Task> tasks;
    for (const LoadedScene& scene : scenes) {
        if (with_luts) {
            for (const PlannedLut& lut : scene.plan.luts) tasks.push_back({&scene, &lut, nullptr, 0});
        }
        for (std::size_t i = 0; i < scene.plan.swatches.size(); ++i)
            tasks.push_back({&scene, nullptr, &scene.plan.swatches[i], i});
    }
    return tasks;
}

void keep_only(std::vector<Task>& tasks, const std::vector<std::string>& only) {
    if (only.empty()) return;
    std::vector<std::string> known;
    for (const Task& task : tasks) known.push_back(task.name());
    for (const std::string& name : only) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const auto near = nearest_names(name, known, 5);
        throw Error("--only " + name + ": the scenes have no LUT or swatch of that name" +
                    (near.empty() ? "" : "; did you mean " + comma_separated(near) + "?"));
    }
    std::erase_if(tasks,
                  [&](const Task& task) { return std::find(only.begin(), only.end(), task.name()) == only.end(); });
}

// "I/N", 1 <= I <= N: every N-th task, beginning with the I-th.
void keep_shard(std::vector<Task>& tasks, const std::string& shard) {
    if (shard.empty()) return;
    unsigned index = 0;
    unsigned count = 0;
    char rest = 0;
    if (std::sscanf(shard.c_str(), "%6u/%6u%c", &index, &count, &rest) != 2 || index < 1 || index > count) {
        throw Error("--shard " + shard + ": is no shard; give I/N with 1 <= I <= N");
    }
    std::vector<Task> kept;
    for (std::size_t i = index - 1; i < tasks.size(); i += count) kept.push_back(tasks[i]);
    tasks = std::move(kept);
}

// Where files go, and what pictures are lettered with.
struct Target {
    OutputFolder& folder;
    std::filesystem::path font;  // empty if there is no picture to draw
    bool force;
};

bool draws_picture(const Task& task) {
    if (task.swatch != nullptr) return true;
    const auto& outputs = task.lut->outputs;
    return std::find(outputs.begin(), outputs.end(), LutOutput::png) != outputs.end();
}

std::string size_text(const Job& job) {
    return std::to_string(job.width) + " x " + std::to_string(job.height);
}

// What makes one file out of bytes: nothing is written that is there already.
void put(const Target& target, const std::string& name, std::string_view bytes, bool& unchanged) {
    if (!target.force && target.folder.holds(name, bytes)) return;
    unchanged = false;
    target.folder.write(name, bytes);
}

std::string swatch_bytes(const PlannedSwatch& swatch, const ColourTransform& transform,
                         const std::filesystem::path& font) {
    const PngSettings settings{font, transform.interop_id() == srgb_display_id, swatch.gamut == Gamut::compress};
    const auto bytes = encode_swatch_png(
        draw_swatch(swatch), [&](const Image<Xyz>& image) { return transform.apply(image); }, settings);
    return {bytes.begin(), bytes.end()};
}

Outcome bake_one_lut(const Task& task, const Target& target) {
    const LoadedScene& scene = *task.scene;
    const PlannedLut& lut = *task.lut;
    const BakedLut baked = bake_lut(lut, scene.plan.colour, scene.source, scene.transform, throw_if_stopped);
    const std::string manifest = manifest_json(lut, baked);
    Outcome outcome;
    outcome.unchanged = true;
    for (const LutOutput output : lut.outputs) {
        const std::string file = lut.name + "." + std::string(name_of(output_words, output));
        switch (output) {
            case LutOutput::exr:
                put(target, file, encode_lut(baked.image, lut.format, baked.header), outcome.unchanged);
                break;
            case LutOutput::json:
                put(target, file, manifest, outcome.unchanged);
                break;
            case LutOutput::png: {
                PlannedSwatch strip;
                strip.title = lut.name;
                strip.jobs = {lut.job};
                put(target, file, swatch_bytes(strip, *scene.strip_transform, target.font), outcome.unchanged);
                break;
            }
        }
    }
    outcome.outside_gamut = baked.gamut.outside;
    outcome.json = nlohmann::ordered_json::parse(manifest);
    outcome.json["unchanged"] = outcome.unchanged;
    outcome.line = output_files(lut).front() + "  " + size_text(lut.job) + " " +
                   std::string(name_of(format_words, lut.format)) + "  " + scene.transform.target();
    if (baked.gamut.outside > 0) {
        outcome.line += "  " + std::to_string(baked.gamut.outside) + " of " + std::to_string(baked.image.size()) +
                        " texels out of gamut, " +
                        (scene.plan.colour.gamut == Gamut::keep   ? "kept"
                         : scene.plan.colour.gamut == Gamut::clip ? "clipped"
                                                                  : "compressed");
    }
    char angle[64];
    if (baked.clamped.below_deg) {
        std::snprintf(angle, sizeof angle, "  clamped below %.1f deg", *baked.clamped.below_deg);
        outcome.line += angle;
    }
    if (baked.clamped.above_deg) {
        std::snprintf(angle, sizeof angle, "  clamped above %.1f deg", *baked.clamped.above_deg);
        outcome.line += angle;
    }
    if (outcome.unchanged) outcome.line += "  (unchanged)";
    return outcome;
}

Outcome bake_one_swatch(const Task& task, const Target& target) {
    const PlannedSwatch& swatch = *task.swatch;
    const ColourTransform& transform = task.scene->swatch_transforms[task.swatch_index];
    Outcome outcome;
    outcome.unchanged = true;
    put(target, swatch.name + ".png", swatch_bytes(swatch, transform, target.font), outcome.unchanged);
    outcome.line = swatch.name + ".png  " + std::string(name_of(swatch_words, swatch.kind)) + "  " +
                   transform.target() + (outcome.unchanged ? "  (unchanged)" : "");
    outcome.json = {{"file", swatch.name + ".png"},
                    {"draw", name_of(swatch_words, swatch.kind)},
                    {"display", transform.display()},
                    {"view", transform.view()},
                    {"unchanged", outcome.unchanged}};
    return outcome;
}

Outcome run_task(const Task& task, const Target& target) {
    try {
        return task.lut != nullptr ? bake_one_lut(task, target) : bake_one_swatch(task, target);
    } catch (const IoError&) {
        throw;  // the disk's refusal ends the batch; a LUT's own failure does not
    } catch (const Error& error) {
        Outcome outcome;
        const Where& where = task.lut != nullptr ? task.lut->where : task.swatch->where;
        outcome.failure = where.text() + " " + task.name() + ": " + error.what();
        return outcome;
    }
}

int report_dry_run(const std::vector<Task>& tasks, Console& console) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Task& task : tasks) {
        const auto files = task.lut != nullptr ? output_files(*task.lut) : output_files(*task.swatch);
        console.summary("would write " + comma_separated(files) +
                        (task.lut != nullptr ? "  " + size_text(task.lut->job) : ""));
        json.push_back({{"files", files}});
    }
    if (console.json()) console.result_json({{"would_write", json}});
    return exit_done;
}

int run_bake(const BakeOptions& options, bool with_luts, Console& console) {
    const std::vector<LoadedScene> scenes = load_scenes(options.scenes, options.ocio, true, console);
    std::vector<Task> tasks = list_tasks(scenes, with_luts);
    keep_only(tasks, options.only);
    keep_shard(tasks, options.shard);
    if (tasks.empty() && !with_luts && options.only.empty() && options.shard.empty())
        throw Error("the scenes have no [swatch.NAME]; add one");
    if (options.dry_run) return report_dry_run(tasks, console);

    const bool any_picture = std::any_of(tasks.begin(), tasks.end(), draws_picture);
    const auto font = any_picture ? find_font() : std::filesystem::path();
    OutputFolder folder(options.folder);
    const Target target{folder, font, options.force};
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    nlohmann::ordered_json json_luts = nlohmann::ordered_json::array();
    nlohmann::ordered_json json_swatches = nlohmann::ordered_json::array();
    nlohmann::ordered_json json_failures = nlohmann::ordered_json::array();
    std::size_t outside_gamut = 0;
    std::atomic<std::size_t> done = 0;
    for (std::size_t begin = 0; begin < tasks.size(); begin += files_per_commit) {
        const std::size_t end = std::min(begin + files_per_commit, tasks.size());
        std::vector<Outcome> outcomes(end - begin);
        arena.execute([&] {
            tbb::parallel_for(begin, end, [&](std::size_t i) {
                throw_if_stopped();
                outcomes[i - begin] = run_task(tasks[i], target);
                console.progress(++done, tasks.size());
            });
        });
        throw_if_stopped();
        folder.commit();
        for (std::size_t i = begin; i < end; ++i) {
            const Outcome& outcome = outcomes[i - begin];
            if (!outcome.failure.empty()) {
                console.error(outcome.failure);
                json_failures.push_back(outcome.failure);
                continue;
            }
            console.summary(outcome.line);
            outside_gamut += outcome.outside_gamut > 0 && tasks[i].scene->plan.colour.gamut == Gamut::keep ? 1 : 0;
            if (console.json()) (tasks[i].lut != nullptr ? json_luts : json_swatches).push_back(outcome.json);
        }
    }
    if (outside_gamut > 0) {
        console.warning(std::to_string(outside_gamut) + (outside_gamut == 1 ? " LUT has" : " LUTs have") +
                        " negative components, because the colour lies outside the target's gamut; [colour] gamut = "
                        "\"clip\" or \"compress\" "
                        "removes them, a wider space keeps the colour");
    }
    if (console.json()) {
        console.result_json({{"luts", json_luts}, {"swatches", json_swatches}, {"failures", json_failures}});
    }
    return json_failures.empty() ? exit_done : exit_some_failed;
}

void declare_common(CLI::App& app, BakeOptions& options) {
    app.add_option("SCENE", options.scenes, "scene files (TOML)")->required()->type_name("");
    app.add_option("-o,--output", options.folder, "folder for the files; made if it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--only", options.only, "only the LUT or swatch of this name; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--ocio", options.ocio, "OpenColorIO config; wins over the scene's, which wins over $OCIO")
        ->type_name("FILE");
    app.add_option("--threads", options.threads, "threads at once; 0: one per core")
        ->type_name("N")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_flag("--force", options.force, "write files that are up to date as well");
    app.add_flag("--dry-run", options.dry_run, "say which files would be written, and stop");
}

}  // namespace

Command add_bake_command(CLI::App& app) {
    const auto options = std::make_shared<BakeOptions>();
    declare_common(app, *options);
    app.add_option("--shard", options->shard, "only every N-th LUT and swatch, from the I-th on; for farms")
        ->type_name("I/N");
    app.footer("\nExample:\n  nacre bake configs/scenes/morpho.toml configs/scenes/beetle.toml -o out\n");
    return [options](Console& console) { return run_bake(*options, true, console); };
}

Command add_swatch_command(CLI::App& app) {
    const auto options = std::make_shared<BakeOptions>();
    declare_common(app, *options);
    app.footer("\nExample:\n  nacre swatch configs/scenes/morpho.toml -o out --only morpho_plane\n");
    return [options](Console& console) { return run_bake(*options, false, console); };
}

}  // namespace nacre
