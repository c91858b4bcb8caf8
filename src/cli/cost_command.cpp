#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/cost_report.h"
#include "cli/report.h"
#include "cli/settled_luts.h"
#include "cli/stop_signal.h"
#include "io/disk/output_folder.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

// A time is the median of so many runs, or of what fits into so many seconds.
constexpr int most_runs = 51;
constexpr int fewest_runs = 3;
constexpr double seconds_per_case = 0.15;

struct CostOptions {
    std::string scene;
    std::string lut;
    std::string ocio;
    std::string folder;
    double accuracy = 0.0;
};

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename Step>
double median_seconds(Step step) {
    std::vector<double> seconds;
    const double begin = now();
    while (static_cast<int>(seconds.size()) < fewest_runs ||
           (static_cast<int>(seconds.size()) < most_runs && now() - begin < seconds_per_case)) {
        throw_if_stopped();
        const double start = now();
        step();
        seconds.push_back(now() - start);
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
}

const PlannedLut& lut_named(const Plan& plan, const std::string& name) {
    if (name.empty()) return plan.luts.front();
    std::vector<std::string> known;
    for (const PlannedLut& lut : plan.luts) {
        if (lut.name == name) return lut;
        known.push_back(lut.name);
    }
    throw Error("--lut " + name + ": the scene has no LUT of that name; known: " + known_like(name, known));
}

// Deciding on the size, and measuring what came out, of one of nacre's own choices.
double overhead_seconds(const CostCase& cost, const PlannedLut& lut, const Encoding& encoding) {
    PlannedLut asked = lut;
    asked.wish = {};
    asked.wish.max_de00 = cost.bound;
    asked.job.light = cost.job.light;
    const double start = now();
    const SettledLut settled = settle(asked, encoding, throw_if_stopped);
    const double decided = now();
    const Image<Rgb> stored = cost.make();
    const double made = now();
    measure(settled.lut.job, stored, encoding, settled.worst);
    return (decided - start) + (now() - made);
}

std::vector<CostRow> measure_costs(const PlannedLut& lut, const Encoding& encoding, double bound, Console& console) {
    std::vector<CostRow> rows;
    std::vector<CostCase> cases = cost_cases(lut, encoding, bound, throw_if_stopped);
    for (CostCase& cost : cases) {
        throw_if_stopped();
        CostRow row;
        row.de00 = cost_error(cost, cost.make(), encoding, throw_if_stopped);
        row.seconds = median_seconds(cost.make);
        row.all_seconds = row.seconds;
        if (cost.family == CostFamily::choice) row.all_seconds += overhead_seconds(cost, lut, encoding);
        row.cost = std::move(cost);
        rows.push_back(std::move(row));
        console.progress(rows.size(), cases.size());
    }
    return rows;
}

int run_cost(const CostOptions& options, Console& console) {
    std::vector<LoadedScene> scenes = load_scenes({options.scene}, options.ocio, false, {}, false, console);
    const LoadedScene& scene = scenes.front();
    const PlannedLut& lut = lut_named(scene.plan, options.lut);
    if (!scene.transform.has_way_back()) {
        throw Error(lut.where.text() + " " + lut.name + ": space " + scene.transform.target() +
                    " has no way back to XYZ, so no error can be measured in it; name another [colour] space");
    }
    const double bound = options.accuracy > 0.0 ? options.accuracy : lut.wish.max_de00;
    const Encoding encoding = lut_encoding(scene.transform, scene.plan.colour.gamut);
    const std::vector<CostRow> rows = measure_costs(lut, encoding, bound, console);
    const std::string comment = "What accuracy costs: LUT " + lut.name +
                                ", one thread; time to compute, convert and round all texels, median of repeated runs";
    if (!options.folder.empty()) {
        OutputFolder folder(options.folder);
        for (const auto& [name, bytes] : cost_picture(rows, lut.name + "_cost", lut.name, bound, comment)) {
            folder.write(name, bytes);
        }
        throw_if_stopped();
        folder.commit();
    }
    for (const std::string& line : cost_lines(rows)) console.summary(line);
    if (console.json()) console.result_json({{"lut", lut.name}, {"max_de00", bound}, {"cases", cost_json(rows)}});
    return exit_done;
}

}  // namespace

Command add_cost_command(CLI::App& app) {
    const auto options = std::make_shared<CostOptions>();
    app.add_option("SCENE", options->scene, "scene file (TOML)")->required()->type_name("");
    app.add_option("--lut", options->lut, "which LUT of the scene; the first if not given")->type_name("NAME");
    app.add_option("-o,--output", options->folder, "also write picture, CSV and gnuplot script into this folder")
        ->type_name("DIR");
    add_accuracy_option(app, options->accuracy);
    app.add_option("--ocio", options->ocio, "OpenColorIO config; wins over the scene's, which wins over $OCIO")
        ->type_name("FILE");
    app.footer(
        "\nMakes a LUT in some sixty ways, and says of each how far its colours are off (CIEDE2000, the largest of "
        "what a\n"
        "shader can fetch) and how long one thread took to make it: nacre's own choice for bounds from 5 to 0.002; "
        "sums\n"
        "over every 1 to 20 nm, fits of the observer, three wavelengths; fixed sizes on every axis; common mistakes;\n"
        "every effect of the material switched off in turn.\n"
        "The picture needs gnuplot (Debian package gnuplot-nox).\n\nExample:\n"
        "  nacre cost configs/scenes/morpho.toml -o out\n");
    return [options](Console& console) { return run_cost(*options, console); };
}

}  // namespace nacre
