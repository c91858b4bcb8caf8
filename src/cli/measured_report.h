#pragma once

#include <string>
#include <vector>

#include "nacre/pick/fit_palette.h"
#include "pipeline/json.h"

namespace nacre {

/// How an answer to measured spectra compares with them, as comment lines of a scene.
/// @param file  of the spectra
/// @param what  was fitted: "palette", "film"
std::string comparison_comment(const std::string& file, const std::string& what, const std::vector<AngleFit>& angles);

/// The same for --json: { angle_deg, measured_peak_nm, peak_nm, peak_error_nm, de00 } of each angle.
Json angles_json(const std::vector<AngleFit>& angles);

}  // namespace nacre
