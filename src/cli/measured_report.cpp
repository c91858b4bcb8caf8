#include "cli/measured_report.h"

#include <cmath>

#include "cli/text_table.h"
#include "nacre/base/text.h"

namespace nacre {

std::string comparison_comment(const std::string& file, const std::string& what, const std::vector<AngleFit>& angles) {
    std::vector<std::vector<std::string>> rows{{"angle", "measured peak", what + " peak", "error", "dE00"}};
    for (const AngleFit& angle : angles) {
        const bool has_peak = std::isfinite(angle.peak_nm);
        rows.push_back({number_text(angle.angle_deg) + " deg", fixed_text(angle.measured_peak_nm, 1) + " nm",
                        has_peak ? fixed_text(angle.peak_nm, 1) + " nm" : "none",
                        has_peak ? fixed_text(angle.peak_nm - angle.measured_peak_nm, 1) + " nm" : "",
                        significant_text(angle.de00, 3)});
    }
    std::string text = "# How this " + what + " fits " + file + ":\n";
    for (const std::string& line : table_lines(rows, {true, true, true, true, true})) text += "#   " + line + "\n";
    return text;
}

Json angles_json(const std::vector<AngleFit>& angles) {
    Json json = Json::array();
    for (const AngleFit& angle : angles) {
        const bool has_peak = std::isfinite(angle.peak_nm);
        Json one{{"angle_deg", angle.angle_deg}, {"measured_peak_nm", angle.measured_peak_nm}};
        one["peak_nm"] = has_peak ? Json(angle.peak_nm) : Json();
        one["peak_error_nm"] = has_peak ? Json(angle.peak_nm - angle.measured_peak_nm) : Json();
        one["de00"] = angle.de00;
        json.push_back(one);
    }
    return json;
}

}  // namespace nacre
