#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/found_report.h"
#include "cli/pick_scene.h"
#include "cli/picked_swatch.h"
#include "cli/settled_luts.h"
#include "cli/stop_signal.h"
#include "cli/text_table.h"
#include "io/ceres_solver.h"
#include "io/scene/scene_file.h"
#include "io/scene/spectra_csv.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/illuminant.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/fit_palette.h"
#include "nacre/pick/missed_picks.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/band.h"
#include "pipeline/baked_lut.h"
#include "pipeline/picked_colours.h"

namespace nacre {
namespace {

// What messages call the scene that the command line stands for.
constexpr const char* scene_name = "picks";

Plan plan_of(const std::string& scene, const PickOptions& options) {
    PlanRequest request;
    request.all_materials = true;
    try {
        return plan_scene(parse_scene(scene, scene_name),
                          scene_files_with_colours(scene_name, options.ocio, throw_if_stopped), request);
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        // Nobody wrote that scene: its lines mean nothing.
        const std::string message = error.what();
        const std::size_t end =
            message.rfind(std::string(scene_name) + ":", 0) == 0 ? message.find(": ") : std::string::npos;
        throw Error(end == std::string::npos ? message : message.substr(end + 2));
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

void print(const PickOptions& options, nlohmann::ordered_json json, std::string scene, Console& console) {
    if (!options.swatch.empty()) write_picked_swatch(options, scene, console);
    json["scene"] = scene;
    scene.pop_back();
    if (console.json()) {
        console.result_json(json);
    } else {
        console.result(scene);
    }
}

nlohmann::ordered_json picked_list(const std::vector<PickedColour>& picked) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PickedColour& one : picked) list.push_back(picked_json(one));
    return list;
}

// ---- a palette

void pick_palette(const PickOptions& options, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const std::string material = asked_lines(options);
    const Plan plan = plan_of(pick_scene(options, material, picks_toml(lines), "", true), options);
    const std::vector<PickedColour>& picked = plan.materials.front().picked;
    for (const PickedColour& one : picked) lines[one.pick].comment = comment_on(one);
    // Of a scene that nobody has seen, no lines are named.
    if (lines.size() == 1)
        console.warning(options.picks.front() +
                        ": one pick says nothing about other angles: the same colour at all of them");
    judge(options, picked, console);
    print(options, {{"picked", picked_list(picked)}}, pick_scene(options, material, picks_toml(lines), "", true),
          console);
}

// ---- any other mechanism

// The answer with its numbers rounded, so that a scene can be read.
Mechanism rounded(const MechanismSearch& search, const FoundMechanism& found) {
    constexpr int digits = 6;
    Mechanism mechanism = search.start;
    for (std::size_t i = 0; i < search.free.size(); ++i)
        search.free[i].set(mechanism, std::stod(significant_text(found.values[i], digits)));
    return mechanism;
}

std::string answers_comment(const MaterialSearch& search, std::size_t chosen) {
    std::string text = "# " + answer_text(search, chosen) + "\n";
    if (search.found.size() > 1) text += "# Others, which --choose N prints:\n";
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        if (i != chosen) text += "#   " + std::to_string(i + 1) + ": " + answer_text(search, i) + "\n";
    }
    return text;
}

// Of spectra that were measured: how the answer compares with them.
std::string comparison(const std::string& file, const std::string& what, const std::vector<AngleFit>& angles) {
    std::vector<std::vector<std::string>> rows{{"angle", "measured peak", "its peak", "error", "dE00"}};
    for (const AngleFit& angle : angles) {
        const bool has_peak = std::isfinite(angle.peak_nm);
        rows.push_back({number_text(angle.angle_deg) + " deg", fixed_text(angle.measured_peak_nm, 1) + " nm",
                        has_peak ? fixed_text(angle.peak_nm, 1) + " nm" : "none",
                        has_peak ? fixed_text(angle.peak_nm - angle.measured_peak_nm, 1) + " nm" : "",
                        significant_text(angle.de00, 3)});
    }
    std::string text = "# " + file + ", and this " + what + ":\n";
    for (const std::string& line : table_lines(rows, {true, true, true, true, true})) text += "#   " + line + "\n";
    return text;
}

nlohmann::ordered_json angles_json(const std::vector<AngleFit>& angles) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const AngleFit& angle : angles) {
        nlohmann::ordered_json one{{"angle_deg", angle.angle_deg}, {"measured_peak_nm", angle.measured_peak_nm}};
        one["peak_nm"] = nullptr;
        one["peak_error_nm"] = nullptr;
        if (std::isfinite(angle.peak_nm)) {
            one["peak_nm"] = angle.peak_nm;
            one["peak_error_nm"] = angle.peak_nm - angle.measured_peak_nm;
        }
        one["de00"] = angle.de00;
        json.push_back(std::move(one));
    }
    return json;
}

// A band near the measured peak, if the mechanism has one there.
std::vector<AngleFit> compared(const MeasuredSpectra& spectra, const SceneMaterial& material) {
    std::vector<AngleFit> angles;
    for (const PickedColour& one : material.picked) {
        const auto found = std::find(spectra.angle_deg.begin(), spectra.angle_deg.end(), one.angle_deg);
        AngleFit angle;
        angle.angle_deg = one.angle_deg;
        angle.measured_peak_nm = measured_peak_nm(spectra, static_cast<std::size_t>(found - spectra.angle_deg.begin()));
        const auto band = find_band(material.mechanism, Incidence::from_degrees(one.angle_deg), angle.measured_peak_nm);
        angle.peak_nm = band ? band->peak_nm : std::numeric_limits<double>::quiet_NaN();
        angle.de00 = one.de00;
        angles.push_back(angle);
    }
    return angles;
}

void pick_mechanism(const PickOptions& options, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const bool is_measured = !options.measured.empty();
    const auto picks = [&] {
        return is_measured ? "{ measured = " + toml_string(options.measured) + " }" : picks_toml(lines);
    };
    const Plan asked = plan_of(pick_scene(options, asked_lines(options), picks(), "", true), options);
    if (asked.searches.empty())
        throw Error("--mechanism " + options.mechanism + ": picks lead to a palette, film, stack, grating or crystal");
    const MaterialSearch& search = asked.searches.front();
    const auto chosen = static_cast<std::size_t>(std::max(options.choose, 1) - 1);
    if (chosen >= search.found.size()) {
        throw Error("--choose " + std::to_string(options.choose) + ": there are " +
                    std::to_string(search.found.size()) + " answers");
    }
    const std::string material = mechanism_toml(rounded(search.search, search.found[chosen]));
    // What is printed is what is judged.
    const Plan answer = plan_of(pick_scene(options, material, picks(), "", true), options);
    std::vector<PickedColour> picked = answer.materials.front().picked;
    for (PickedColour& one : picked) one.is_searched = !search.search.free.empty();
    if (!is_measured) {
        for (const PickedColour& one : picked) lines[one.pick].comment = comment_on(one);
    }
    nlohmann::ordered_json json{{"picked", picked_list(picked)}, {"found", found_json(search)}};
    std::string comments = answers_comment(search, chosen);
    if (is_measured) {
        const auto angles = compared(read_spectra_csv(options.measured), answer.materials.front());
        comments = comparison(options.measured, options.mechanism, angles) + comments;
        json["angles"] = angles_json(angles);
    }
    // Of measurements the comparison says it all.
    if (!is_measured || options.strict) judge(options, picked, console);
    print(options, std::move(json), pick_scene(options, material, picks(), comments, true), console);
}

// ---- a palette of measured spectra

void pick_measured_palette(const PickOptions& options, Console& console) {
    if (!options.with.empty()) throw Error("--with and --measured: the palette is fitted whole; leave --with out");
    const MeasuredSpectra spectra = read_spectra_csv(options.measured);
    const std::size_t count = options.count > 0 ? static_cast<std::size_t>(options.count)
                                                : std::min<std::size_t>(2, spectra.angle_deg.size());
    if (count > spectra.angle_deg.size()) {
        throw Error("--picks " + std::to_string(count) + ": " + options.measured + " has " +
                    std::to_string(spectra.angle_deg.size()) + " angles");
    }
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    const Light light = make_light(settings);
    const PaletteFit fit = fit_palette(spectra, count, light, least_squares_solver());
    Palette palette = fit.palette;
    const auto round = [](double& value, int decimals) { value = std::stod(fixed_text(value, decimals)); };
    for (Pick& pick : palette.picks) {
        round(pick.lobe.peak_nm, 3);
        round(pick.lobe.width_nm, 3);
        round(pick.lobe.height, 6);
    }
    round(palette.shape, 6);
    print(options, {{"error", fit.error}, {"angles", angles_json(fit.angles)}},
          pick_scene(options, mechanism_toml(Mechanism(palette)), "",
                     comparison(options.measured, "palette", fit.angles), false),
          console);
}

int run_pick(const PickOptions& options, Console& console) {
    const bool is_measured = !options.measured.empty();
    if (is_measured == !options.picks.empty())
        throw Error("nacre pick takes colours, COLOUR@ANGLE, or --measured FILE; give one of the two");
    check_with(options.with);
    check_swatch_name(options);
    if (options.count > 0 && !(is_measured && is_palette(options)))
        throw Error(
            "--picks: is how many bands of a palette stand for measured spectra; give it with --measured alone");
    if (options.choose > 0 && is_palette(options))
        throw Error("--choose: a palette is the one answer to its picks; give --mechanism, or leave it out");
    if (!is_palette(options)) {
        pick_mechanism(options, console);
    } else if (is_measured) {
        pick_measured_palette(options, console);
    } else {
        pick_palette(options, console);
    }
    return exit_done;
}

}  // namespace

Command add_pick_command(CLI::App& app) {
    const auto options = std::make_shared<PickOptions>();
    app.add_option("COLOUR@ANGLE", options->picks,
                   "#rrggbb, #rgb or r,g,b, and the angle in degrees at which it is seen; one or more")
        ->type_name("");
    app.add_option("--measured", options->measured,
                   "a CSV of spectra at several angles (wavelength_nm, then a column per angle) instead of colours")
        ->type_name("FILE");
    app.add_option("--picks", options->count, "so many picks of a palette stand for measured spectra; default: 2")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    app.add_option("--mechanism", options->mechanism, "palette (default), film, stack, grating or crystal")
        ->type_name("NAME");
    app.add_option("--with", options->with,
                   "a line of the material in TOML: index = 1.33 fixes it, index = { from = 1.3, to = 1.5 } bounds it; "
                   "may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    app.add_option("--choose", options->choose, "which of the answers, best first; default: 1")
        ->type_name("N")
        ->check(CLI::Range(1, 100));
    app.add_option("--space", options->space,
                   "colour space of the OpenColorIO config that the colours are in; default: its role color_picking")
        ->type_name("NAME");
    app.add_option("--name", options->name, "name of the material")->type_name("NAME")->capture_default_str();
    app.add_option("--swatch", options->swatch, "a picture too: picked beside reached, and the strip between them")
        ->type_name("FILE.png");
    app.add_option("--ocio", options->ocio, "OpenColorIO config; wins over $OCIO")->type_name("FILE");
    add_strict_option(app, options->strict);
    app.footer(
        "\nPrints a scene: what was picked, and what shows it. A palette has a band of reflectance per pick. Of any "
        "other\n"
        "mechanism, what --with does not fix is looked for:\n"
        "  film     index 1.2-2.6, thickness_nm 0-1500, substrate 1-4\n"
        "  stack    two layers in turn: film 1.2-2.6, film_nm 20-400, gap 1-2.6, gap_nm 20-400, films 1-40, substrate "
        "1-4\n"
        "  grating  period_nm 400-5000, grooves 1-200, depth_nm 10-400, land 0.05-0.5; light along the normal\n"
        "  crystal  sphere 1-2.6, medium 1-2.6, diameter_nm 120-600, planes 1-100\n"
        "The best answer is printed, up to four others stand in its comments. What cannot be had is warned of, with "
        "its\n"
        "distance in CIEDE2000.\n\n"
        "Examples:\n"
        "  nacre pick \"#22cc66@0\" \"#1fb5c9@50\" > mine.toml && nacre bake mine.toml -o out\n"
        "  nacre pick \"#3a6fd0@0\" \"#7030b0@40\" --mechanism film --with 'substrate = \"si\"'\n"
        "  nacre pick --measured configs/scenes/gold_beetle.csv --picks 3\n");
    return [options](Console& console) { return run_pick(*options, console); };
}

}  // namespace nacre
