#include "cli/common_options.h"

#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

// More threads than any machine has; oneTBB would reserve a stack for each.
constexpr Allowed allowed_threads{0, 1024};

}  // namespace

Option scenes_option(std::vector<std::string>& scenes) {
    return {.names = "SCENE", .target = &scenes, .help = "scene files (TOML)", .is_required = true};
}

Option only_option(std::vector<std::string>& names) {
    return {.names = "--only",
            .target = &names,
            .help = "use only the LUTs and swatches with these names, as in --only a b or --only a,b; default: all",
            .value_name = "NAME",
            .is_list = true};
}

Option ocio_option(std::string& file) {
    return {.names = "--ocio",
            .target = &file,
            .help = "OpenColorIO config; default: that of the scene, else $OCIO, else the config that nacre contains",
            .value_name = "FILE"};
}

std::vector<Option> colour_options(ColourOverride& asked) {
    return {
        {.names = "--space",
         .target = &asked.space,
         .help = "colour space of all LUTs; default: that of the scene, else with $OCIO the role scene_linear of its "
                 "config, else lin_rec709; nacre list spaces prints the names",
         .value_name = "NAME"},
        {.names = "--display",
         .target = &asked.display,
         .help = "display of all pictures; default: that of the scene, else the config's; nacre list displays prints "
                 "the names",
         .value_name = "NAME"},
        {.names = "--view",
         .target = &asked.view,
         .help = "view of the display, of all pictures; default: that of the scene, or with --display the default "
                 "of the display",
         .value_name = "NAME"}};
}

Option threads_option(int& threads) {
    return {.names = "--threads",
            .target = &threads,
            .help = "number of threads; 0 means one per core",
            .value_name = "N",
            .shows_default = true,
            .range = allowed_threads};
}

Option strict_option(bool& is_strict) {
    return {.names = "--strict",
            .target = &is_strict,
            .help = "treat a picked colour that cannot be reached as an error instead of a warning"};
}

Option set_option(std::vector<std::string>& edits) {
    return {.names = "--set",
            .target = &edits,
            .help =
                "change a value of the scenes, for example --set material.hero.picks[0].colour=#aa2244; a string "
                "needs no quotes; may be repeated",
            .value_name = "KEY=VALUE"};
}

Option accuracy_option(double& bound) {
    return {.names = "--accuracy",
            .target = &bound,
            .help = "largest colour error (CIEDE2000); default: max_de00 of the scene, else 0.1",
            .value_name = "DE",
            .range = allowed_max_de00};
}

Option effects_option(std::string& word) {
    return {.names = "--effects",
            .target = &word,
            .help =
                "auto: leave out effects that change colours by less than their share of the error bound; all: "
                "simulate every effect that the scene names; default: effects of the scene, else auto",
            .value_name = "auto|all",
            .allowed = {"auto", "all"}};
}

}  // namespace nacre
