#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "nacre/accuracy/trial.h"

namespace nacre {

/// Where a LUT errs most.
struct Scan {
    double largest = 0.0;         ///< CIEDE2000; of the points looked at, if the scan was cut short
    LutPoint at;                  ///< of the largest
    std::vector<LutPoint> worst;  ///< the worst point of each of the worst cells, the worst of all first
    std::size_t points = 0;       ///< that were looked at
    bool is_complete = true;      ///< false: an error above the limit was met, and the rest was not looked at
};

/// The largest error over all coordinates: between the texels too, where the linear filter leaves the curve.
///
/// Every cell is looked at on an even grid, two points a side, more where cells are few, and at
/// the model's breakpoints (picks; where a clamp begins). Then the worst cells once more, finely, and their worst
/// points are closed in on. A LUT so large that this were more than some millions of points is looked at on every n-th
/// line only.
/// @param limit  stop at an error above this
/// @param first  points to scan before all others: where a smaller LUT erred
/// @param unrounded  scan the LUT as it was before its numbers were rounded to the format
Scan scan_errors(Trial& trial, double limit = std::numeric_limits<double>::infinity(),
                 std::span<const LutPoint> first = {}, bool unrounded = false);

/// What of the largest error a scan finds at least.
double share_found_by_scan(const Job& job);

/// Coordinates on x at which the model turns sharply: picks, and angles at which a clamp begins; where these lie near
/// each other, between and beside them too.
std::vector<double> breakpoints(const Job& job, double y);

}  // namespace nacre
