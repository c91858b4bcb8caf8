#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/cost_report.h"
#include "cli/execution.h"
#include "cli/scenes.h"
#include "cli/stop_signal.h"
#include "io/disk/output_folder.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/baked_lut.h"
#include "pipeline/json.h"
#include "pipeline/measure_costs.h"

namespace nacre {
namespace {

struct CostOptions {
    std::string scene;
    std::string lut;
    std::string ocio;
    std::string folder;
    double accuracy = 0.0;
};

// The LUT of that name, and the scene that it is of: a scene with variants is several.
std::pair<const LoadedScene*, const PlannedLut*> lut_named(const std::vector<LoadedScene>& scenes,
                                                           const std::string& name) {
    std::vector<std::string> known;
    for (const LoadedScene& scene : scenes) {
        for (const PlannedLut& lut : scene.plan.luts) {
            if (name.empty() || lut.name == name) return {&scene, &lut};
            known.push_back(lut.name);
        }
    }
    throw Error("--lut " + in_quotes(name) + ": the scene has no LUT of that name; known: " + known_like(name, known));
}

int run_cost(const CostOptions& options, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.want_swatches = false;
    const std::vector<LoadedScene> scenes = open_scenes({options.scene}, request, console);
    const auto [scene, named] = lut_named(scenes, options.lut);
    const PlannedLut& lut = *named;
    const ColourSpace& space = scene->space_of(lut.colour);
    if (!space.has_inverse()) {
        throw Error(lut.where.text() + " " + lut.name + ": space " + space.name() +
                    " has no inverse to XYZ, so no error can be measured in it; name another space");
    }
    const double bound = options.accuracy > 0.0 ? options.accuracy : lut.request.max_de00;
    const Encoding encoding = lut_encoding(space, lut.colour.gamut);
    const std::vector<CostRow> rows = measure_costs(lut, encoding, bound, execution_on(1, console));
    const std::string comment =
        "What accuracy costs: LUT " + lut.name +
        ", seconds of one thread, medians of repeated runs: to compute, convert and round all texels; to "
        "decide on size, format and sampling; to measure the error";
    if (!options.folder.empty()) {
        OutputFolder folder(options.folder);
        for (const auto& [name, bytes] : cost_picture(rows, lut.name + "_cost", lut.name, bound, comment)) {
            folder.write(name, bytes);
        }
        throw_if_stopped();
        folder.commit();
    }
    for (const std::string& line : cost_lines(rows)) console.summary(line);
    if (console.json()) console.result_json(Json{{"lut", lut.name}, {"max_de00", bound}, {"cases", cost_json(rows)}});
    return exit_done;
}

}  // namespace

Command cost_command() {
    const auto options = std::make_shared<CostOptions>();
    Command command{"cost", "compare error and time of about sixty ways to make a LUT: table, CSV, picture", {}, {}};
    command.options = {
        {.names = "SCENE", .target = &options->scene, .help = "scene file (TOML)", .is_required = true},
        {.names = "--lut",
         .target = &options->lut,
         .help = "which LUT of the scene; default: the first",
         .value_name = "NAME"},
        {.names = "-o,--output",
         .target = &options->folder,
         .help =
             "also write the picture, its CSV and its gnuplot script into this folder; default: print the table only",
         .value_name = "DIR"},
        accuracy_option(options->accuracy),
        ocio_option(options->ocio)};
    command.footer =
        "\nMakes one LUT in about sixty ways. Each row shows the error of its colours (CIEDE2000, the largest error "
        "of\n"
        "what a shader can fetch) and the time that one thread computed. The ways are nacre's own choice for bounds\n"
        "from 5 to 0.002; sums over every 1 to 20 nm, analytic fits of the CIE observer, three wavelengths; fixed\n"
        "sizes on every axis; common mistakes; and every effect of the material switched off in turn.\n"
        "\n"
        "Times are medians of repeated runs. Computing is all of the texels, converted and rounded; deciding is on\n"
        "size, format and sampling; measuring is the check that tells the error. Only nacre's choice decides "
        "anything:\n"
        "the other ways get the sampling that nacre found for the bound, and have to be checked like every LUT.\n"
        "The picture needs gnuplot (Debian package gnuplot-nox).\n\nExample:\n"
        "  nacre cost configs/scenes/morpho.toml -o out\n";
    command.run = [options](Console& console) { return run_cost(*options, console); };
    return command;
}

}  // namespace nacre
