#include "cli/picked_scene.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/execution.h"
#include "cli/found_report.h"
#include "cli/measured_report.h"
#include "cli/picked_swatch.h"
#include "cli/scenes.h"
#include "io/scene/spectra_csv.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/band/pale_path.h"
#include "nacre/pick/fit_palette.h"
#include "nacre/pick/unmatched_picks.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "pipeline/compare_mechanisms.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/manifest.h"
#include "pipeline/pick_answer.h"
#include "pipeline/pick_scene.h"

namespace nacre {
namespace {

// What messages call the scene that the command line stands for.
constexpr const char* scene_name = "picks";

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
    request.wants_pale_paths = true;
    request.on_warning = {};
    try {
        return plan_text(scene, scene_name, request);
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        throw Error(without_places(error.what()));
    }
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
    for (const UnmatchedPick& unmatched : unmatched_picks(picked)) {
        const std::string message =
            unmatched.picked.text + " at " + number_text(unmatched.picked.angle_deg) + " deg: " + unmatched.text;
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

// The value of the key `picks`.
std::string picks_of(const PickOptions& options, const std::vector<PickLine>& lines) {
    return options.measured.empty() ? picks_toml(lines) : "{ measured = " + toml_string(options.measured) + " }";
}

// The plan of the scene that holds the picks and nothing else.
Plan plan_of_picks(const PickOptions& options, Console& console) {
    const std::string picks = picks_of(options, pick_lines(options));
    return plan_of(scene_text({options.name, asked_lines(options), picks, "", true}), options, console);
}

PickOptions with_mechanism(const PickOptions& options, const std::string& mechanism) {
    PickOptions other = options;
    other.mechanism = mechanism;
    return other;
}

// ---- what other mechanisms make of the same colours

// A plan per mechanism, made on all cores: a search takes up to some seconds.
std::vector<Plan> plans_of(const std::vector<std::string>& mechanisms, const PickOptions& options, Console& console) {
    std::vector<Plan> plans(mechanisms.size());
    execution_on(0, console).for_each(mechanisms.size(), [&](std::size_t i) {
        plans[i] = plan_of_picks(with_mechanism(options, mechanisms[i]), console);
    });
    return plans;
}

// What is printed above the material, and the same in JSON.
struct Remarks {
    std::string comments;
    Json json = Json::object();
};

// A film and a stack that are worth naming beside a palette.
Remarks others_beside(const MechanismAnswer& palette, const PickOptions& options, Console& console) {
    const std::vector<std::string> others{"film", "stack"};
    const std::vector<Plan> plans = plans_of(others, options, console);
    Remarks beside{{}, {{"beside", Json::array()}}};
    for (std::size_t i = 0; i < others.size(); ++i) {
        const std::vector<MechanismAnswer> answers = mechanism_answers(plans[i], others[i]);
        const MechanismAnswer* named = answer_beside(palette, answers);
        if (named == nullptr) continue;
        beside.comments += "# also: " + mechanism_answer_text(*named) + "\n";
        beside.json["beside"].push_back(mechanism_answer_json(*named));
    }
    return beside;
}

std::string answers_comment(const MaterialSearch& search, std::size_t chosen) {
    std::string text = "# " + answer_text(search, chosen) + "\n";
    if (search.found.size() > 1) text += "# Other answers; --choose N prints the N-th:\n";
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        if (i != chosen) text += "#   " + std::to_string(i + 1) + ": " + answer_text(search, i) + "\n";
    }
    return text;
}

// ---- scenes of an answer

void show_palette(const PickOptions& options, const Plan& plan, Remarks remarks, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const SceneMaterial& material = plan.materials.front();
    for (const PickedColour& one : material.picked) lines[one.pick].comment = comment_on(one);
    // Of a scene that nobody has seen, no lines are named.
    if (lines.size() == 1)
        console.warning(options.picks.front() +
                        ": one pick gives the same colour at every angle; add a pick at another angle");
    judge(options, material.picked, console);
    std::string comments;
    for (const PalePath& path : material.pale_paths) {
        comments += "# " + pale_path_text(path, std::get<Palette>(material.mechanism)) + "\n";
        Json pale{{"chroma", path.chroma}};
        if (path.middle_helps) pale["middle_pick"] = middle_pick_text(path);
        remarks.json["pale_paths"].push_back(std::move(pale));
    }
    remarks.json["picked"] = picked_list(material.picked);
    print(options, std::move(remarks.json),
          scene_text({options.name, asked_lines(options), picks_toml(lines), comments + remarks.comments, true}),
          console);
}

// @param asked  the plan that found it
void show_found(const PickOptions& options, const Plan& asked, std::size_t answer, Remarks remarks, Console& console) {
    std::vector<PickLine> lines = pick_lines(options);
    const MaterialSearch& search = asked.searches.front();
    const std::string material = mechanism_toml(rounded_answer(search, answer));
    // What is printed is what is judged.
    const Plan plan =
        plan_of(scene_text({options.name, material, picks_of(options, lines), "", true}), options, console);
    std::vector<PickedColour> picked = plan.materials.front().picked;
    const auto& tolerance = search.found[answer].tolerance;
    for (std::size_t i = 0; i < picked.size(); ++i) {
        picked[i].is_searched = !search.search.free.empty();
        if (tolerance) picked[i].tolerance = tolerance->per_colour[i];
    }
    const bool is_measured = !options.measured.empty();
    if (is_measured) {
        const auto angles = compare_with_measured(read_spectra_csv(options.measured), plan.materials.front());
        remarks.comments = comparison_comment(options.measured, options.mechanism, angles) + remarks.comments;
        remarks.json["angles"] = angles_json(angles);
    } else {
        for (const PickedColour& one : picked) lines[one.pick].comment = comment_on(one);
    }
    // Of measurements the comparison says it all.
    if (!is_measured || options.strict) judge(options, picked, console);
    remarks.json["picked"] = picked_list(picked);
    remarks.json["found"] = found_json(search);
    print(options, std::move(remarks.json),
          scene_text({options.name, material, picks_of(options, lines), remarks.comments, true}), console);
}

// Which of so many answers --choose asks for.
std::size_t chosen_of(const PickOptions& options, std::size_t answers) {
    const auto chosen = static_cast<std::size_t>(std::max(options.choose, 1) - 1);
    if (chosen < answers) return chosen;
    throw Error("--choose " + std::to_string(options.choose) + ": the answers are 1 to " + std::to_string(answers) +
                "; give one of these numbers");
}

}  // namespace

void print_palette(const PickOptions& options, bool with_others, Console& console) {
    const Plan plan = plan_of_picks(options, console);
    Remarks remarks;
    if (with_others) remarks = others_beside(mechanism_answers(plan, "palette").front(), options, console);
    show_palette(options, plan, std::move(remarks), console);
}

void print_found_mechanism(const PickOptions& options, Console& console) {
    const Plan asked = plan_of_picks(options, console);
    if (asked.searches.empty())
        throw Error("--mechanism " + options.mechanism + ": picks can lead to " +
                    comma_separated(mechanisms_with_picks()));
    const MaterialSearch& search = asked.searches.front();
    const std::size_t chosen = chosen_of(options, search.found.size());
    show_found(options, asked, chosen, {answers_comment(search, chosen)}, console);
}

void print_best_mechanism(const PickOptions& options, Console& console) {
    const std::vector<std::string> names = mechanisms_with_picks();
    const std::vector<Plan> plans = plans_of(names, options, console);
    std::vector<MechanismAnswer> answers;
    for (std::size_t i = 0; i < names.size(); ++i) answers.push_back(mechanism_answers(plans[i], names[i]).front());
    rank(answers);
    const std::size_t chosen = chosen_of(options, answers.size());
    Remarks remarks;
    remarks.comments = "# " + mechanism_answer_line(answers[chosen]) +
                       "\n# Other mechanisms; --mechanism auto --choose N prints the N-th:\n";
    for (std::size_t i = 0; i < answers.size(); ++i) {
        remarks.json["ranked"].push_back(mechanism_answer_json(answers[i]));
        if (i != chosen)
            remarks.comments += "#   " + std::to_string(i + 1) + ": " + mechanism_answer_line(answers[i]) + "\n";
    }
    const std::string& best = answers[chosen].mechanism;
    const Plan& plan = plans[static_cast<std::size_t>(std::find(names.begin(), names.end(), best) - names.begin())];
    if (plan.searches.empty()) {
        show_palette(with_mechanism(options, best), plan, std::move(remarks), console);
    } else {
        show_found(with_mechanism(options, best), plan, answers[chosen].answer, std::move(remarks), console);
    }
}

void print_measured_palette(const PickOptions& options, Console& console) {
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

}  // namespace nacre
