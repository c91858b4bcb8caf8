// nacre: palette picks and other causes of iridescence -> angle-to-RGB lookup textures. This file is the front door: it
// hands the command line to one of the commands (one file each), and catches what they throw, once.
#include <exception>
#include <iostream>
#include <new>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/options.h"
#include "cli/stop_signal.h"
#include "nacre/base/error.h"

namespace {

int run(const nacre::Command& command, nacre::Console& console) {
    try {
        const int code = command.run(console);
        console.finish();
        return code;
    } catch (const nacre::StopRequested& stop) {
        console.error("stopped; every file that was written is complete");
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
        const std::vector<nacre::Command> commands{
            nacre::init_command(), nacre::bake_command(),     nacre::swatch_command(), nacre::plan_command(),
            nacre::cost_command(), nacre::spectrum_command(), nacre::pick_command(),   nacre::verify_command(),
            nacre::list_command(), nacre::snippet_command(),  nacre::figures_command()};
        const nacre::Asked asked = nacre::parse_command_line(argc, argv, commands);
        if (asked.command == nullptr) return nacre::exit_done;
        nacre::Console console(asked.console);
        return run(*asked.command, console);
    } catch (const nacre::Error& error) {
        nacre::Console({}).error(error.what());
        return nacre::exit_wrong_input;
    } catch (const std::exception& error) {
        std::cerr << "nacre: internal error: " << error.what() << "\n";
        return nacre::exit_io;
    }
}
