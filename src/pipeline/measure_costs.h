#pragma once

#include <vector>

#include "nacre/cost/cost.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/execution.h"

namespace nacre {

/// A way to make a LUT, with what it turned out to cost: seconds of one thread's computing, each the median of runs.
struct CostRow {
    CostCase cost;
    double de00 = 0.0;               ///< reached, as a bake tells it
    double computing_seconds = 0.0;  ///< to compute the texels, convert and round them
    double deciding_seconds = 0.0;   ///< on sampling, where that is nacre's; of a choice on size and format, too
    double measuring_seconds = 0.0;  ///< the error, as a bake does

    double all_seconds() const { return computing_seconds + deciding_seconds + measuring_seconds; }
};

/// Makes the LUT in every way of cost_cases(), one after the other on this thread, and takes error and times of each.
///
/// A way that nobody decides on has no time for that, but the same check as nacre's choice; one of a fixed size that is
/// made with the sampling that nacre decides on is charged for that. The colours of tilted facets are a part of
/// computing, though nacre has them from deciding: what they take is left out of deciding, so that all together is what
/// a bake takes.
/// @param encoding  has to outlive the rows
/// @pre the encoding has a way back to XYZ
std::vector<CostRow> measure_costs(const PlannedLut& lut, const Encoding& encoding, double bound,
                                   const Execution& execution);

}  // namespace nacre
