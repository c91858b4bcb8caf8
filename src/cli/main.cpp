// nacre: palette picks and other causes of iridescence -> angle-to-RGB lookup textures. This file is the front door: it
// hands the command line to one of the commands (one file each), and catches what they throw, once.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/stop_signal.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "pipeline/baked_lut.h"

namespace {

constexpr const char* description =
    "nacre turns palette picks, films, stacks, gratings, crystals, scattering and measurements into colour-managed\n"
    "angle-to-RGB lookup textures for iridescent surfaces.";

constexpr const char* footer =
    "\nExit codes: 0 all done; 1 some LUTs failed, the others were written; 2 the scene or the command line is wrong,\n"
    "nothing was written; 3 input or output; 4 accuracy or verification not met; 143 stopped by SIGTERM.\n\n"
    "Example:\n  nacre bake configs/scenes/morpho.toml -o out\n";

std::string known_commands(const std::vector<std::pair<CLI::App*, nacre::Command>>& commands) {
    std::vector<std::string> names;
    for (const auto& [subcommand, command] : commands) names.push_back(subcommand->get_name());
    return nacre::comma_separated(names);
}

int run(int argc, char** argv) {
    CLI::App app(description, "nacre");
    app.set_version_flag("--version", "nacre " + std::string(nacre::nacre_version()));
    app.footer(footer);
    app.require_subcommand(1);
    app.fallthrough();
    nacre::ConsoleOptions options;
    app.add_flag("--json", options.json, "results as JSON on standard output");
    app.add_flag("-q,--quiet", options.quiet, "say nothing but errors");
    app.add_flag("-v,--verbose", options.verbose, "say what is done, on standard error");

    std::vector<std::pair<CLI::App*, nacre::Command>> commands;
    const auto add = [&](const char* name, const char* what, nacre::Command (*declare)(CLI::App&)) {
        CLI::App* command = app.add_subcommand(name, what);
        commands.emplace_back(command, declare(*command));
        command->footer("All commands take --json, --quiet and --verbose.\n" + command->get_footer());
    };
    add("bake", "scenes to LUTs, manifests and swatches", nacre::add_bake_command);
    add("swatch", "the pictures of scenes only", nacre::add_swatch_command);
    add("plan", "what will be baked, how large, how exact, how long", nacre::add_plan_command);
    add("cost", "error against time for every method and size: table, CSV, picture", nacre::add_cost_command);
    add("spectrum", "reflectance spectra, or XYZ, as CSV with 17 digits", nacre::add_spectrum_command);
    add("pick", "colours at angles to a scene", nacre::add_pick_command);
    add("verify", "derive LUTs again from their headers and compare", nacre::add_verify_command);
    add("snippet", "the shader code that fetches from a LUT", nacre::add_snippet_command);
    add("figures", "the figures of Park & Tsuruno 2014: data, gnuplot scripts and plots", nacre::add_figures_command);

    // CLI11 would call a misspelt command a missing one.
    const auto word = std::find_if(argv + 1, argv + argc, [](const char* argument) { return argument[0] != '-'; });
    const auto is_word = [&](const auto& command) { return command.first->get_name() == *word; };
    if (word != argv + argc && std::none_of(commands.begin(), commands.end(), is_word)) {
        std::cerr << "nacre: unknown command " << nacre::in_quotes(*word) << "; known: " << known_commands(commands)
                  << "\n";
        return nacre::exit_wrong_input;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {
        return app.exit(request);  // --help, --version
    } catch (const CLI::ParseError& error) {
        std::cerr << "nacre: " << error.what() << "; see nacre --help\n";
        return nacre::exit_wrong_input;
    }

    nacre::Console console(options);
    try {
        int code = nacre::exit_done;
        for (const auto& [subcommand, command] : commands) {
            if (subcommand->parsed()) code = command(console);
        }
        console.finish();
        return code;
    } catch (const nacre::StopRequested& stop) {
        console.error("stopped; what was written is whole");
        return 128 + stop.signal;
    } catch (const nacre::IoError& error) {
        console.error(error.what());
        return nacre::exit_io;
    } catch (const nacre::Error& error) {
        console.error(error.what());
        return nacre::exit_wrong_input;
    } catch (const std::bad_alloc&) {
        console.error("out of memory");
        return nacre::exit_io;
    }
}

}  // namespace

int main(int argc, char** argv) {
    nacre::watch_stop_signals();
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "nacre: internal error: " << error.what() << "\n";
        return nacre::exit_io;
    }
}
