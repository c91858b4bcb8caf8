#include "cli/found_report.h"

#include <algorithm>

#include "nacre/base/text.h"

namespace nacre {

std::string answer_text(const MaterialSearch& search, std::size_t answer) {
    const FoundMechanism& found = search.found[answer];
    constexpr std::size_t most_listed = 4;
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
    return text + ")";
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
        json.push_back(one);
    }
    return json;
}

}  // namespace nacre
