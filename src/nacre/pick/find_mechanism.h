#pragma once

#include <functional>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/light.h"
#include "nacre/pick/mechanism_search.h"

namespace nacre {

/// How far a search goes.
struct SearchEffort {
    int table = 16384;  ///< designs that are looked at
    int valleys = 192;  ///< of these, the best that differ are followed for some steps
    int starts = 32;    ///< of these, the best are refined to the end
    int leaps = 8;      ///< from each of the best few of them, per round, to valleys near by
    int answers = 5;    ///< of what they become, the best that differ are returned, at most
};

/// What suits a mechanism with so many free numbers.
SearchEffort effort_for(const MechanismSearch& search);

/// The designs that come nearest to the wanted colours, best first: those that meet them to `as_good_as_met`, the
/// simplest of them ahead; then the others by error.
///
/// A table of designs, spread evenly over the ranges of all free numbers at once (EvenPoints), finds the valleys; least
/// squares of CIEDE2000's parts find their bottoms, and leaps from the best of them valleys beside those. No chance is
/// in it: the same search has the same answers. Without free numbers the one answer is the start, judged.
/// @param after_step  called every few designs; what it throws ends the search
std::vector<FoundMechanism> find_mechanisms(const MechanismSearch& search, const Light& light,
                                            const LeastSquaresSolver& solve, const SearchEffort& effort,
                                            const std::function<void()>& after_step = {});

/// The valley that values of the free numbers lie in, down to its bottom. Whole numbers stay.
FoundMechanism refine_mechanism(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
                                const std::vector<double>& values);

/// CIEDE2000 below which two answers are equally good.
inline constexpr double as_good_as_met = 0.1;

}  // namespace nacre
