#pragma once

#include <vector>

#include "nacre/cost/cost.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/execution.h"

namespace nacre {

/// A way to make a LUT, with what it turned out to cost.
struct CostRow {
    CostCase cost;
    double de00 = 0.0;         ///< reached
    double seconds = 0.0;      ///< to compute the texels, convert and round them: the median of the runs
    double all_seconds = 0.0;  ///< of a choice: with deciding and measuring; else the same as seconds
};

/// Makes the LUT in every way of cost_cases(), one after the other on this thread, and takes error and time of each.
/// @param encoding  has to outlive the rows
/// @pre the encoding has a way back to XYZ
std::vector<CostRow> measure_costs(const PlannedLut& lut, const Encoding& encoding, double bound,
                                   const Execution& execution);

}  // namespace nacre
