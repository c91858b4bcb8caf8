#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/report.h"
#include "cli/stop_signal.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
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

int run_verify(const std::vector<std::string>& files, Console& console) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    int code = exit_done;
    for (const std::string& file : files) {
        throw_if_stopped();
        try {
            const StoredLut stored = read_lut(file);
            const Verification found = verify_lut(stored, throw_if_stopped);
            if (!found.passed() && code == exit_done) code = exit_not_verified;
            console.summary(file + ": " + verdict_text(stored, found));
            json.push_back({{"file", file},
                            {"verified", found.passed()},
                            {"missing", found.missing},
                            {"contradicting", found.wrong},
                            {"problem", found.problem},
                            {"max_de00", found.error ? nlohmann::ordered_json(*found.error) : nullptr},
                            {"differing_components", found.differing},
                            {"largest_difference", found.largest_difference}});
        } catch (const IoError& error) {  // one file that cannot be read says nothing about the others
            console.error(error.what());
            json.push_back({{"file", file}, {"verified", false}, {"problem", error.what()}});
            code = exit_io;
        }
    }
    if (console.json()) console.result_json(json);
    return code;
}

}  // namespace

Command add_verify_command(CLI::App& app) {
    const auto files = std::make_shared<std::vector<std::string>>();
    app.add_option("FILE", *files, "LUTs (EXR) that nacre baked")->required()->type_name("");
    app.footer(
        "\nExit code 4 if one of them does not verify, 3 if one cannot be read.\n\nExample:\n  nacre verify "
        "luts/*.exr\n");
    return [files](Console& console) { return run_verify(*files, console); };
}

}  // namespace nacre
