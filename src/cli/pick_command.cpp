#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/found_report.h"
#include "cli/measured_report.h"
#include "cli/pick_words.h"
#include "cli/picked_swatch.h"
#include "cli/scenes.h"
#include "io/scene/spectra_csv.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/band/pale_path.h"
#include "nacre/pick/fit_palette.h"
#include "nacre/pick/missed_picks.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/manifest.h"
#include "pipeline/pick_answer.h"
#include "pipeline/pick_scene.h"

namespace nacre {
namespace {

// What messages call the scene that the command line stands for.
constexpr const char* scene_name = "picks";

// More than any search returns, and than a palette of measured spectra can use.
constexpr double most_counted = 100;

// Nobody wrote that scene: its lines mean nothing. A message of several mistakes has a line for each.
std::string without_places(const std::string& message) {
    const std::string file = std::string(scene_name) + ":";
    std::string rest;
    for (std::size_t begin = 0; begin <= message.size();) {
        const std::size_t end = std::min(message.find('\n', begin), message.size());
        std::string line = message.substr(begin, end - begin);
        const std::size_t place = line.starts_with(file) ? line.find(": ") : std::string::npos;
        if (place != std::string::npos) line.erase(0, place + 2);
        // Picks often share a mistake, and without its places it is the same line.
        const bool is_new = ("\n" + rest + "\n").find("\n" + line + "\n") == std::string::npos;
        if (is_new) rest += (rest.empty() ? "" : "\n") + line;
        begin = end + 1;
    }
    return rest;
}

Plan plan_of(const std::string& scene, const PickOptions& options, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.all_materials = true;
    request.on_warning = {};
    try {
        return plan_text(scene, scene_name, request);
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        throw Error(without_places(error.what()));
    }
}

bool is_palette(const PickOptions& options) {
    return options.mechanism.empty() || options.mechanism == "palette";
}

// The material's lines as the command line gives them.
std::string asked_lines(const PickOptions& options) {
    std::string lines;
    if (!options.mechanism.empty()) lines += "mechanism = " + toml_string(options.mechanism) + "\n";
    for (const std::string& line : options.with) lines += line + "\n";
    return lines;
}

std::string comment_on(const PickedColour& picked) {
    if (!picked.lobe) return "dE00 " + significant_text(picked.de00, 2);
    return "peak_nm = " + significant_text(picked.lobe->peak_nm, 5) +
           ", width_nm = " + significant_text(picked.lobe->width_nm, 4) +
           ", height = " + significant_text(picked.lobe->height, 3) +
           (picked.lobe->floor != 0.0 ? ", floor = " + significant_text(picked.lobe->floor, 3) : "") +
           (picked.lobe->flatness != 0.0 ? ", flatness = " + significant_text(picked.lobe->flatness, 3) : "") +
           (picked.is_met() ? std::string(", exact") : ", dE00 " + significant_text(picked.de00, 3));
}

void judge(const PickOptions& options, const std::vector<PickedColour>& picked, Console& console) {
    for (const MissedPick& missed : missed_picks(picked)) {
        const std::string message =
            missed.picked.text + " at " + number_text(missed.picked.angle_deg) + " deg: " + missed.text;
        if (options.strict) throw Error(message);
        console.warning(message);
    }
}

void print(const PickOptions& options, Json json, std::string scene, Console& console) {
    if (!options.swatch.empty()) write_picked_swatch(options, scene, console);
    json["scene"] = scene;
    scene.pop_back();
    if (console.json()) {
        console.result_json(json);
    } else {
        console.result(scene);
    }
}

Json picked_list(const std::vector<PickedColour>& picked) {
    Json list = Json::array();
    for (const PickedColour& one : picked) list.push_back(picked_json(one));
    return list;
}

// ---- a palette

void pick_palette(const PickOptions& options, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const std::string material = asked_lines(options);
    const Plan plan = plan_of(scene_text({options.name, material, picks_toml(lines), "", true}), options, console);
    const std::vector<PickedColour>& picked = plan.materials.front().picked;
    for (const PickedColour& one : picked) lines[one.pick].comment = comment_on(one);
    // Of a scene that nobody has seen, no lines are named.
    if (lines.size() == 1)
        console.warning(options.picks.front() +
                        ": one pick gives the same colour at every angle; add a pick at another angle");
    judge(options, picked, console);
    Json json{{"picked", picked_list(picked)}};
    std::string comments;
    const auto& palette = std::get<Palette>(plan.materials.front().mechanism);
    for (const PalePath& path : plan.materials.front().pale_paths) {
        comments += "# " + pale_path_text(path, palette) + "\n";
        Json pale{{"chroma", path.chroma}};
        if (path.middle_helps) pale["middle_pick"] = middle_pick_text(path);
        json["pale_paths"].push_back(std::move(pale));
    }
    print(options, std::move(json), scene_text({options.name, material, picks_toml(lines), comments, true}), console);
}

// ---- any other mechanism

std::string answers_comment(const MaterialSearch& search, std::size_t chosen) {
    std::string text = "# " + answer_text(search, chosen) + "\n";
    if (search.found.size() > 1) text += "# Other answers; --choose N prints the N-th:\n";
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        if (i != chosen) text += "#   " + std::to_string(i + 1) + ": " + answer_text(search, i) + "\n";
    }
    return text;
}

void pick_mechanism(const PickOptions& options, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const bool is_measured = !options.measured.empty();
    const auto picks = [&] {
        return is_measured ? "{ measured = " + toml_string(options.measured) + " }" : picks_toml(lines);
    };
    const Plan asked = plan_of(scene_text({options.name, asked_lines(options), picks(), "", true}), options, console);
    if (asked.searches.empty())
        throw Error("--mechanism " + options.mechanism + ": picks can lead to " + mechanisms_with_picks());
    const MaterialSearch& search = asked.searches.front();
    const auto chosen = static_cast<std::size_t>(std::max(options.choose, 1) - 1);
    if (chosen >= search.found.size()) {
        throw Error("--choose " + std::to_string(options.choose) + ": the answers are 1 to " +
                    std::to_string(search.found.size()) + "; give one of these numbers");
    }
    const std::string material = mechanism_toml(rounded_answer(search, chosen));
    // What is printed is what is judged.
    const Plan answer = plan_of(scene_text({options.name, material, picks(), "", true}), options, console);
    std::vector<PickedColour> picked = answer.materials.front().picked;
    for (PickedColour& one : picked) one.is_searched = !search.search.free.empty();
    if (!is_measured) {
        for (const PickedColour& one : picked) lines[one.pick].comment = comment_on(one);
    }
    Json json{{"picked", picked_list(picked)}, {"found", found_json(search)}};
    std::string comments = answers_comment(search, chosen);
    if (is_measured) {
        const auto angles = compare_with_measured(read_spectra_csv(options.measured), answer.materials.front());
        comments = comparison_comment(options.measured, options.mechanism, angles) + comments;
        json["angles"] = angles_json(angles);
    }
    // Of measurements the comparison says it all.
    if (!is_measured || options.strict) judge(options, picked, console);
    print(options, std::move(json), scene_text({options.name, material, picks(), comments, true}), console);
}

// ---- a palette of measured spectra

void pick_measured_palette(const PickOptions& options, Console& console) {
    if (!options.with.empty())
        throw Error("--with and --measured: every number of the palette is fitted; leave --with out");
    const MeasuredSpectra spectra = read_spectra_csv(options.measured);
    const std::size_t count = options.count > 0 ? static_cast<std::size_t>(options.count)
                                                : std::min<std::size_t>(2, spectra.angle_deg.size());
    if (count > spectra.angle_deg.size()) {
        throw Error("--picks " + std::to_string(count) + ": " + options.measured + " has " +
                    std::to_string(spectra.angle_deg.size()) + " angles");
    }
    const PaletteFit fit = fit_readable_palette(spectra, count);
    const std::string comments = comparison_comment(options.measured, "palette", fit.angles);
    print(options, Json{{"error", fit.error}, {"angles", angles_json(fit.angles)}},
          scene_text({options.name, mechanism_toml(Mechanism(fit.palette)), "", comments, false}), console);
}

int run_pick(const PickOptions& options, Console& console) {
    const bool is_measured = !options.measured.empty();
    if (is_measured == !options.picks.empty())
        throw Error("nacre pick takes colours, COLOUR@ANGLE, or --measured FILE; give one of the two");
    check_with(options.with);
    check_swatch_name(options);
    if (options.count > 0 && !(is_measured && is_palette(options)))
        throw Error(
            "--picks sets the number of palette picks for measured spectra; give it only with --measured, and without "
            "another --mechanism");
    if (options.choose > 0 && is_palette(options))
        throw Error("--choose: a palette is the only answer; give another --mechanism, or leave --choose out");
    if (!is_palette(options)) {
        pick_mechanism(options, console);
    } else if (is_measured) {
        pick_measured_palette(options, console);
    } else {
        pick_palette(options, console);
    }
    return exit_done;
}

std::vector<Option> options_of(PickOptions& options) {
    return {
        {.names = "COLOUR@ANGLE",
         .target = &options.picks,
         .help = "colours (#rrggbb, #rgb or r,g,b), each with the angle in degrees at which it is seen"},
        {.names = "--measured",
         .target = &options.measured,
         .help = "CSV file of spectra at several angles (wavelength_nm, then a column per angle), instead of colours",
         .value_name = "FILE"},
        {.names = "--picks",
         .target = &options.count,
         .help = "number of picks of the palette that is fitted to measured spectra; default: 2",
         .value_name = "N",
         .range = Allowed{1, most_counted}},
        {.names = "--mechanism",
         .target = &options.mechanism,
         .help = mechanisms_with_picks() + "; default: palette",
         .value_name = "NAME"},
        {.names = "--with",
         .target = &options.with,
         .help =
             "a line of the material in TOML: index = 1.33 fixes a number, index = { from = 1.3, to = 1.5 } bounds it; "
             "may be repeated",
         .value_name = "KEY=VALUE"},
        {.names = "--choose",
         .target = &options.choose,
         .help = "print the N-th of the answers, the best of which is the first; default: 1",
         .value_name = "N",
         .range = Allowed{1, most_counted}},
        {.names = "--space",
         .target = &options.space,
         .help = "colour space of the colours, from the OpenColorIO config; default: its role color_picking",
         .value_name = "NAME"},
        {.names = "--name",
         .target = &options.name,
         .help = "name of the material",
         .value_name = "NAME",
         .shows_default = true},
        {.names = "--swatch",
         .target = &options.swatch,
         .help = "also draw a picture: each picked colour beside the colour that the material reaches, and a strip "
                 "over all angles",
         .value_name = "FILE.png"},
        ocio_option(options.ocio),
        strict_option(options.strict)};
}

}  // namespace

Command pick_command() {
    const auto options = std::make_shared<PickOptions>();
    Command command{"pick", "turn colours at angles into a scene", options_of(*options), {}};
    command.footer =
        "\nPrints a scene with the picks and the material that shows them. A palette has one band of reflectance per\n"
        "pick. For any other mechanism, nacre searches these numbers, except those that --with fixes:\n"
        "  film     index 1.2-2.6, thickness_nm 0-1500, substrate 1-4\n"
        "  stack    two layers in turn: film 1.2-2.6, film_nm 20-400, gap 1-2.6, gap_nm 20-400, films 1-40, substrate "
        "1-4\n"
        "  grating  period_nm 400-5000, grooves 1-200, depth_nm 10-400, land 0.05-0.5; light along the normal\n"
        "  crystal  sphere 1-2.6, medium 1-2.6, diameter_nm 120-600, planes 1-100\n"
        "The scene holds the best answer; up to four others are listed in its comments. A palette shows every colour\n"
        "that a reflectance can have, and dims any other at its own hue; another mechanism comes as near as it can. A\n"
        "warning names each pick that is not shown as it was picked, with its distance in CIEDE2000.\n\n"
        "Examples:\n"
        "  nacre pick \"#22cc66@0\" \"#1fb5c9@50\" > mine.toml && nacre bake mine.toml -o out\n"
        "  nacre pick \"#3a6fd0@0\" \"#7030b0@40\" --mechanism film --with 'substrate = \"si\"'\n"
        "  nacre pick --measured configs/scenes/gold_beetle.csv --picks 3\n";
    command.run = [options](Console& console) { return run_pick(*options, console); };
    return command;
}

}  // namespace nacre
