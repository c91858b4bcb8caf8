#include "cli/found_report.h"

#include <algorithm>

#include "nacre/base/text.h"
#include "pipeline/manifest.h"

namespace nacre {
namespace {

constexpr std::size_t most_listed = 4;  // errors of picks

// Two digits, but no more than hundredths: what is less cannot be seen.
std::string short_de00(double de00) {
    return number_text(std::stod(de00 < 0.1 ? fixed_text(de00, 2) : significant_text(de00, 2)));
}

// "dE00 0.35 and 1, through cyan and blue".
std::string outcome_text(const MechanismAnswer& answer) {
    const std::string through = path_text(answer.path);
    std::string text = "dE00 ";
    if (answer.de00.size() > most_listed) {
        text += "at most " + short_de00(*std::max_element(answer.de00.begin(), answer.de00.end()));
    } else {
        for (std::size_t i = 0; i < answer.de00.size(); ++i) {
            text += i == 0 ? "" : i + 1 < answer.de00.size() ? ", " : " and ";
            text += short_de00(answer.de00[i]);
        }
    }
    return text + (through.empty() ? "" : ", " + through);
}

}  // namespace

std::string answer_text(const MaterialSearch& search, std::size_t answer) {
    const FoundMechanism& found = search.found[answer];
    std::string text = found_text(search.search, found) + " (dE00 ";
    if (found.de00.size() > most_listed) {
        text += "at most " + significant_text(*std::max_element(found.de00.begin(), found.de00.end()), 2) + ", ";
    } else if (found.de00.size() > 1) {
        for (const double de00 : found.de00) text += significant_text(de00, 2) + ", ";
    }
    text += (found.de00.size() > 1 ? "together " : "") + significant_text(found.error, 2);
    if (found.near_error) {
        text += "; with the nearest materials, ";
        for (const NearMaterial& near : found.near) text += near.key + " " + near.material + ", ";
        text += "together " + significant_text(*found.near_error, 2);
    }
    if (found.tolerance) {
        const Tolerance& tolerance = *found.tolerance;
        text += "; thicknesses off by " + number_text(tolerance.thickness_nm) + " nm move the colour by dE00 " +
                significant_text(tolerance.shift.mean, 2) + " on average, " +
                significant_text(tolerance.shift.percentile_95, 2) + " at the 95th percentile";
    }
    return text + ")";
}

std::string mechanism_answer_text(const MechanismAnswer& answer) {
    return "--mechanism " + answer.mechanism +
           (answer.answer > 0 ? " --choose " + std::to_string(answer.answer + 1) : "") + ": " + outcome_text(answer);
}

std::string mechanism_answer_line(const MechanismAnswer& answer) {
    return answer.mechanism + (answer.text.empty() ? "" : ": " + answer.text) + " (" + outcome_text(answer) + ")";
}

Json mechanism_answer_json(const MechanismAnswer& answer) {
    return {{"mechanism", answer.mechanism}, {"choose", answer.answer + 1},  {"de00", answer.de00},
            {"error", answer.error},         {"chroma", answer.path.chroma}, {"through", answer.path.hues}};
}

Json found_json(const MaterialSearch& search) {
    Json json = Json::array();
    for (const FoundMechanism& found : search.found) {
        Json one;
        for (std::size_t i = 0; i < found.values.size(); ++i)
            one["values"][search.search.free[i].name] = found.values[i];
        one["de00"] = found.de00;
        one["error"] = found.error;
        for (const NearMaterial& near : found.near)
            one["nearest_materials"][near.key] = {{"material", near.material}, {"distance", near.distance}};
        if (found.near_error) one["error_of_nearest_materials"] = *found.near_error;
        if (found.tolerance) {
            one["tolerance"] = shift_json(found.tolerance->shift);
            one["tolerance"]["thickness_nm"] = found.tolerance->thickness_nm;
        }
        json.push_back(one);
    }
    return json;
}

}  // namespace nacre
