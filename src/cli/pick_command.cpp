#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/pick_words.h"
#include "cli/picked_scene.h"
#include "cli/picked_swatch.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {
namespace {

// More than any search returns, and than a palette of measured spectra can use.
constexpr double most_counted = 100;

// Compares all mechanisms.
constexpr const char* any_mechanism = "auto";

bool is_palette(const PickOptions& options) {
    return options.mechanism.empty() || options.mechanism == "palette";
}

void check_automatic(const PickOptions& options) {
    const std::string names = comma_separated(mechanisms_with_picks());
    if (!options.measured.empty())
        throw Error("--mechanism auto compares what mechanisms make of colours; with --measured, name one of " + names);
    if (!options.with.empty())
        throw Error("--with and --mechanism auto: each mechanism has keys of its own; name one of " + names);
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
    if (options.mechanism == any_mechanism) {
        check_automatic(options);
        print_best_mechanism(options, console);
    } else if (!is_palette(options)) {
        print_found_mechanism(options, console);
    } else if (is_measured) {
        print_measured_palette(options, console);
    } else {
        print_palette(options, options.mechanism.empty(), console);
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
         .help = comma_separated(mechanisms_with_picks()) +
                 ", or auto, the best of these; default: palette, with a comment if a film or a stack does it too",
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
        "A stack may have layers of its own instead, in which any number may be free. With a tolerance in --with,\n"
        "'tolerance = { thickness_nm = 2 }', each answer tells how far its colour moves when the free thicknesses are\n"
        "off by 2 nm (standard deviation).\n"
        "The scene holds the best answer; up to four others are listed in its comments. A palette shows every colour\n"
        "that a reflectance can have, and dims any other at its own hue; another mechanism comes as near as it can. A\n"
        "warning names each pick that is not shown as it was picked, with its distance in CIEDE2000.\n\n"
        "Beside a palette, a comment names a film or a stack that meets the picks too, or that leads through hues "
        "where\n"
        "the palette is grey; the search takes one to two seconds, and --mechanism palette leaves it out. --mechanism "
        "auto\n"
        "prints the best of all mechanisms and lists what the others make of the picks.\n\n"
        "Examples:\n"
        "  nacre pick \"#22cc66@0\" \"#1fb5c9@50\" > mine.toml && nacre bake mine.toml -o out\n"
        "  nacre pick \"#3a6fd0@0\" \"#7030b0@40\" --mechanism film --with 'substrate = \"si\"'\n"
        "  nacre pick \"#dbfffd@0\" \"#fae7fd@60\" --mechanism stack --with 'substrate = \"ag\"' \\\n"
        "      --with 'layers = [ { index = \"ag\" }, { index = \"sio2\" } ]'\n"
        "  nacre pick --measured configs/scenes/gold_beetle.csv --picks 3\n";
    command.run = [options](Console& console) { return run_pick(*options, console); };
    return command;
}

}  // namespace nacre
