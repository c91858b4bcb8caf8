#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/effect_table.h"
#include "cli/execution.h"
#include "cli/plan_notes.h"
#include "cli/plan_report.h"
#include "cli/previews.h"
#include "cli/report.h"
#include "cli/scenes.h"
#include "cli/stop_signal.h"
#include "pipeline/decide.h"
#include "pipeline/effect_shares.h"
#include "pipeline/json.h"
#include "pipeline/plan_seconds.h"

namespace nacre {
namespace {

struct PlanOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> only;
    std::vector<std::string> edits;
    std::string ocio;
    ColourOverride colours;
    double accuracy = 0.0;
    std::string effects;
    int threads = 0;
    bool strict = false;
};

// The rows of LUTs about which something could be decided; errors for the others.
std::vector<PlanRow> plan_rows(const std::vector<DecidedLut>& luts, const Execution& execution, Console& console) {
    std::vector<PlanRow> rows;
    for (const DecidedLut& lut : luts) {
        throw_if_stopped();
        if (!lut.failure.empty()) {
            console.error(lut.failure);
            continue;
        }
        rows.push_back({&lut, seconds_of_bake(lut, execution), effect_shares(lut, execution)});
    }
    return rows;
}

void print(const std::vector<PlanRow>& rows, const std::vector<LoadedScene>& scenes, Console& console) {
    for (const std::string& line : plan_lines(rows)) console.summary(line);
    console.summary("");
    for (const PlanRow& row : rows) {
        if (row.lut->space().has_inverse()) {
            for (const std::string& line : error_lines(*row.lut)) console.summary(line);
        }
        if (const std::string wide = width_text(row.lut->lut.lut.job); !wide.empty())
            console.summary(row.lut->lut.lut.name + ": " + wide + "; a larger bound needs fewer texels");
        for (const std::string& line : effect_lines(row.lut->lut.lut.name, row.effects)) console.summary(line);
        console.summary("");
    }
    for (const LoadedScene& scene : scenes) note_scene(scene, console);
}

int run_plan(const PlanOptions& options, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.only = options.only;
    request.edits = scene_edits(options.edits);
    request.strict = options.strict;
    request.wants_pale_paths = true;
    request.colours = options.colours;
    std::vector<LoadedScene> scenes = open_scenes(options.scenes, request, console);
    override_accuracy(scenes, accuracy_override(options.accuracy, options.effects));
    choose_previews(scenes, {}, PreviewRule::if_few, false);
    std::vector<DecidedLut> luts = undecided_luts(scenes);
    const Execution execution = execution_on(options.threads, console);
    decide_all(luts, execution);
    const std::vector<PlanRow> rows = plan_rows(luts, execution, console);
    print(rows, scenes, console);
    if (console.json()) {
        Json json = Json::array();
        for (const PlanRow& row : rows) json.push_back(plan_json(row));
        console.result_json(Json{{"luts", json}});
    }
    if (report_out_of_reach(luts, false, console) > 0) return exit_not_verified;
    return rows.size() < luts.size() ? exit_some_failed : exit_done;
}

}  // namespace

Command plan_command() {
    const auto options = std::make_shared<PlanOptions>();
    Command command{"plan", "print what will be baked: size, accuracy, time", {}, {}};
    command.options = {scenes_option(options->scenes),   accuracy_option(options->accuracy),
                       effects_option(options->effects), only_option(options->only),
                       set_option(options->edits),       ocio_option(options->ocio),
                       threads_option(options->threads), strict_option(options->strict)};
    for (Option& option : colour_options(options->colours)) command.options.push_back(std::move(option));
    command.footer =
        "\nThe table shows for each LUT its axes, size and number format, how spectra are integrated, the expected "
        "error\n"
        "(CIEDE2000, the largest over the LUT), and about how long one thread of this machine bakes and measures it,\n"
        "found by timing a few texels. The integral is exact, or the number of wavelengths (nodes; several numbers "
        "where\n"
        "more are needed towards grazing angles) times the number of random thicknesses, of radii or of slices. The "
        "last\n"
        "column is the colour space, with the OpenColorIO config that it is from.\n"
        "Below the table stand the parts of the error, the largest first, and the effects of the material: simulated,\n"
        "or negligible because leaving one out changes colours by less than its share of the error bound. Effects are\n"
        "sorted by cost: the share of the time of its texels that a LUT without the effect would save.\n"
        "Nothing is written. The exit code is 4 if an error bound that you gave is out of reach.\n\nExample:\n"
        "  nacre plan configs/scenes/morpho.toml --accuracy 0.5\n";
    command.run = [options](Console& console) { return run_plan(*options, console); };
    return command;
}

}  // namespace nacre
