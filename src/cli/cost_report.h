#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/json.h"
#include "pipeline/measure_costs.h"

namespace nacre {

/// As a table for people: one line per row, the families under headings.
std::vector<std::string> cost_lines(const std::vector<CostRow>& rows);
/// As CSV; `comment` says what was measured.
std::string cost_csv(const std::vector<CostRow>& rows, const std::string& comment);
Json cost_json(const std::vector<CostRow>& rows);

/// The picture: PNG, its data and its gnuplot script, by file name.
/// @param name   of the files: <name>.png, <name>.csv, <name>.gp
/// @param bound  where the line is drawn
/// @throws IoError if gnuplot is missing or fails
std::vector<std::pair<std::string, std::string>> cost_picture(const std::vector<CostRow>& rows, const std::string& name,
                                                              const std::string& title, double bound,
                                                              const std::string& comment);

}  // namespace nacre
