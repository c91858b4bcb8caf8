#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "io/baked_lut.h"
#include "nacre/bake/names.h"
#include "nacre/bake/text.h"
#include "nacre/error.h"

namespace nacre {
namespace {

std::string verdict_text(const StoredLut& stored, const Verification& found) {
    if (found.passed())
        return "verified: header complete, " + std::to_string(stored.image.size()) + " texels equal a re-bake";
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
    bool all_passed = true;
    for (const std::string& file : files) {
        const StoredLut stored = read_lut(file);
        const Verification found = verify_lut(stored);
        all_passed = all_passed && found.passed();
        console.summary(file + ": " + verdict_text(stored, found));
        json.push_back({{"file", file},
                        {"verified", found.passed()},
                        {"missing", found.missing},
                        {"contradicting", found.wrong},
                        {"problem", found.problem},
                        {"differing_components", found.differing},
                        {"largest_difference", found.largest_difference}});
    }
    if (console.json()) console.result(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return all_passed ? exit_done : exit_not_verified;
}

}  // namespace

Command add_verify_command(CLI::App& app) {
    const auto files = std::make_shared<std::vector<std::string>>();
    app.add_option("FILE", *files, "LUTs (EXR) that nacre baked")->required()->type_name("");
    app.footer("\nExit code 4 if one of them does not verify.\n\nExample:\n  nacre verify luts/*.exr\n");
    return [files](Console& console) { return run_verify(*files, console); };
}

}  // namespace nacre
