#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/report.h"
#include "cli/stop_signal.h"
#include "io/image/lut_file.h"
#include "io/ocio/ocio_spaces.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "pipeline/json.h"
#include "pipeline/verify_lut.h"

namespace nacre {
namespace {

std::string verdict_text(const StoredLut& stored, const Verification& found) {
    if (found.passed())
        return "verified: header complete, " + std::to_string(stored.image.size()) + " texels equal a re-bake" +
               (found.error ? ", dE00 up to " + short_number(*found.error) : "");
    std::string text = "NOT verified:";
    if (!found.missing.empty()) text += " the header lacks " + comma_separated(found.missing) + ";";
    if (!found.wrong.empty()) text += " the header contradicts its scene in " + comma_separated(found.wrong) + ";";
    if (!found.problem.empty()) text += " " + found.problem + ";";
    if (found.differing > 0) {
        text += " " + std::to_string(found.differing) + " components differ from a re-bake, by up to " +
                number_text(found.largest_difference) + ";";
    }
    text.pop_back();
    return text;
}

Json verdict_json(const std::string& file, const Verification& found) {
    return {{"file", file},
            {"verified", found.passed()},
            {"missing", found.missing},
            {"contradicting", found.wrong},
            {"problem", found.problem},
            {"max_de00", found.error ? Json(*found.error) : Json()},
            {"differing_components", found.differing},
            {"largest_difference", found.largest_difference}};
}

int run_verify(const std::vector<std::string>& files, Console& console) {
    Json json = Json::array();
    int code = exit_done;
    for (const std::string& file : files) {
        throw_if_stopped();
        try {
            const StoredLut stored = read_lut(file);
            const Verification found = verify_lut(stored, ocio_space_of_text, throw_if_stopped);
            if (!found.passed() && code == exit_done) code = exit_not_verified;
            console.summary(file + ": " + verdict_text(stored, found));
            json.push_back(verdict_json(file, found));
        } catch (const IoError& error) {  // one file that cannot be read says nothing about the others
            console.error(error.what());
            json.push_back(Json{{"file", file}, {"verified", false}, {"problem", error.what()}});
            code = exit_io;
        }
    }
    if (console.json()) console.result_json(json);
    return code;
}

}  // namespace

Command verify_command() {
    const auto files = std::make_shared<std::vector<std::string>>();
    Command command{"verify", "bake LUTs again from their headers and compare", {}, {}};
    command.options = {
        {.names = "FILE", .target = files.get(), .help = "LUTs (EXR) that nacre baked", .is_required = true}};
    command.footer =
        "\nThe exit code is 4 if a LUT does not verify, and 3 if a file cannot be read.\n\nExample:\n"
        "  nacre verify luts/*.exr\n";
    command.run = [files](Console& console) { return run_verify(*files, console); };
    return command;
}

}  // namespace nacre
