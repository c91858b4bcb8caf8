#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/settled_luts.h"
#include "io/baked_lut.h"
#include "io/picked_colours.h"
#include "io/scene_file.h"
#include "nacre/bake/hex_colour.h"
#include "nacre/bake/names.h"
#include "nacre/bake/text.h"
#include "nacre/error.h"

namespace nacre {
namespace {

struct PickOptions {
    std::vector<std::string> picks;
    std::string space;
    std::string name = "picked";
    std::string ocio;
    bool strict = false;
};

// One argument, COLOUR@ANGLE, as the scene has it.
struct Argument {
    std::string text;
    std::string colour;  // "\"#rrggbb\"" or "[r, g, b]"
    double angle_deg = 0.0;
};

double number_in(const std::string& text, const std::string& argument, const char* what) {
    double value = 0.0;
    if (!text.empty() && CLI::detail::lexical_cast(text, value)) return value;
    throw Error(argument + ": " + in_quotes(text) + " is no " + what + "; give COLOUR@ANGLE, as in \"#22cc66@0\"");
}

// "#rrggbb", "#rgb" or three numbers with commas between.
std::string colour_in(const std::string& text, const std::string& argument) {
    if (parse_hex_colour(text)) return toml_string(text);
    if (std::count(text.begin(), text.end(), ',') != 2)
        throw Error(argument + ": " + in_quotes(text) + " is no colour; give \"#rrggbb\", \"#rgb\" or r,g,b");
    std::string list = "[";
    std::size_t begin = 0;
    for (int component = 0; component < 3; ++component) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        list +=
            (component > 0 ? ", " : "") + number_text(number_in(text.substr(begin, end - begin), argument, "number"));
        begin = end + 1;
    }
    return list + "]";
}

Argument parse_argument(const std::string& text) {
    const std::size_t at = text.rfind('@');
    if (at == std::string::npos) throw Error(text + ": has no angle; give COLOUR@ANGLE, as in \"#22cc66@0\"");
    Argument argument{text, colour_in(text.substr(0, at), text), number_in(text.substr(at + 1), text, "angle")};
    if (!(argument.angle_deg >= 0.0 && argument.angle_deg <= 90.0))
        throw Error(text + ": the angle is out of range; allowed [0, 90] degrees");
    return argument;
}

std::string heading(const char* kind, const std::string& name) {
    const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char character) {
        return std::isalnum(character) != 0 || character == '_' || character == '-';
    });
    return "[" + std::string(kind) + "." + (is_bare ? name : toml_string(name)) + "]\n";
}

// @param comments  as many as arguments, or none
std::string scene_of(const PickOptions& options, const std::vector<Argument>& arguments,
                     const std::vector<std::string>& comments) {
    std::string text = "nacre = 1\n\n" + heading("material", options.name) + "picks = [\n";
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        text += "    { angle_deg = " + number_text(arguments[i].angle_deg) + ", colour = " + arguments[i].colour;
        if (!options.space.empty()) text += ", space = " + toml_string(options.space);
        text += " },";
        if (!comments.empty()) text += "  # " + comments[i];
        text += "\n";
    }
    text += "]\n\n" + heading("swatch", options.name + "_strip") +
            "draw = \"strip\"\nmaterial = " + toml_string(options.name) + "\n\n" +
            heading("swatch", options.name + "_sphere") + "draw = \"sphere\"\nmaterial = " + toml_string(options.name) +
            "\n";
    return text;
}

std::string band_text(const PickedColour& picked) {
    return "peak_nm = " + significant_text(picked.lobe.peak_nm, 5) +
           ", width_nm = " + significant_text(picked.lobe.width_nm, 4) +
           ", height = " + significant_text(picked.lobe.height, 3) +
           (picked.lobe.miss == LobeMiss::none ? std::string(", exact")
                                               : ", dE00 " + significant_text(picked.lobe.de00, 3));
}

int run_pick(const PickOptions& options, Console& console) {
    std::vector<Argument> arguments;
    for (const std::string& text : options.picks) arguments.push_back(parse_argument(text));
    if (arguments.size() < 2) {
        throw Error(options.picks.front() +
                    ": is one pick; give two or more (the colour at one angle says nothing about the others)");
    }
    const Plan plan = plan_scene(parse_scene(scene_of(options, arguments, {}), "picks"),
                                 scene_files_with_colours("picks", options.ocio));
    const std::vector<PickedColour>& picked = plan.materials.front().picked;
    std::vector<std::string> comments;
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < picked.size(); ++i) {
        comments.push_back(band_text(picked[i]));
        json["picked"].push_back(picked_json(picked[i]));
        if (picked[i].lobe.miss == LobeMiss::none) continue;
        const std::string message = arguments[i].text + ": the nearest band is " + match_text(picked[i]);
        if (options.strict) throw Error(message);
        console.warning(message);
    }
    std::string scene = scene_of(options, arguments, comments);
    json["scene"] = scene;
    scene.pop_back();
    if (console.json()) {
        console.result_json(json);
    } else {
        console.result(scene);
    }
    return exit_done;
}

}  // namespace

Command add_pick_command(CLI::App& app) {
    const auto options = std::make_shared<PickOptions>();
    app.add_option("COLOUR@ANGLE", options->picks,
                   "two or more: #rrggbb, #rgb or r,g,b, and the angle in degrees at which it is seen")
        ->required()
        ->type_name("");
    app.add_option("--space", options->space,
                   "colour space of the OpenColorIO config that the colours are in; default: its role color_picking")
        ->type_name("NAME");
    app.add_option("--name", options->name, "name of the material")->type_name("NAME")->capture_default_str();
    app.add_option("--ocio", options->ocio, "OpenColorIO config; wins over $OCIO")->type_name("FILE");
    add_strict_option(app, options->strict);
    app.footer(
        "\nPrints a scene: the picks, and behind each the band of reflectance that it becomes. Colours that no band "
        "has "
        "are\nwarned of, with their distance in CIEDE2000.\n\nExample:\n"
        "  nacre pick \"#22cc66@0\" \"#1fb5c9@50\" > mine.toml && nacre bake mine.toml -o out\n");
    return [options](Console& console) { return run_pick(*options, console); };
}

}  // namespace nacre
