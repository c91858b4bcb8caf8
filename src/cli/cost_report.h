#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "nacre/cost/cost.h"

namespace nacre {

/// A way to make a LUT, with what it turned out to cost.
struct CostRow {
    CostCase cost;
    double de00 = 0.0;         ///< reached
    double seconds = 0.0;      ///< to compute the texels, convert and round them: the median of the runs
    double all_seconds = 0.0;  ///< of a choice: with deciding and measuring; else the same as seconds
};

/// As a table for people: one line per row, the families under headings.
std::vector<std::string> cost_lines(const std::vector<CostRow>& rows);
/// As CSV; `comment` says what was measured.
std::string cost_csv(const std::vector<CostRow>& rows, const std::string& comment);
nlohmann::ordered_json cost_json(const std::vector<CostRow>& rows);

/// The picture: PNG, its data and its gnuplot script, by file name.
/// @param name   of the files: <name>.png, <name>.csv, <name>.gp
/// @param bound  where the line is drawn
/// @throws IoError if gnuplot is missing or fails
std::vector<std::pair<std::string, std::string>> cost_picture(const std::vector<CostRow>& rows, const std::string& name,
                                                              const std::string& title, double bound,
                                                              const std::string& comment);

}  // namespace nacre
