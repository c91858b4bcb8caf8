#pragma once

#include <functional>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/light.h"
#include "nacre/pick/mechanism_search.h"

namespace nacre {

/// The effort of a search.
struct SearchEffort {
    int table = 16384;      ///< designs that are tried
    int valleys = 192;      ///< of these, the best that differ are followed for some steps
    int starts = 32;        ///< of these, the best are refined to the end
    int perturbations = 8;  ///< from each of the best few of them, per round, to valleys near by
    int answers = 5;        ///< of what they become, the best that differ are returned, at most
};

/// The effort for a mechanism with a number of free numbers.
SearchEffort effort_for(const MechanismSearch& search);

/// The designs whose colours are nearest to the requested ones, best first: those that meet them to `as_good_as_met`,
/// sorted by simplicity; then the others, sorted by error.
///
/// The search starts from a table of designs, spread evenly over the ranges of all free numbers (EvenPoints). It
/// refines the best of them by least squares of the parts of CIEDE2000, and then retries from perturbed designs near
/// the best (basin hopping). It uses no random numbers, so the same search has the same answers. Without free numbers
/// the only answer is the start with its errors.
/// @param after_step  called every few designs; an exception from it ends the search
std::vector<FoundMechanism> find_mechanisms(const MechanismSearch& search, const Light& light,
                                            const LeastSquaresSolver& solve, const SearchEffort& effort,
                                            const std::function<void()>& after_step = {});

/// Refines values of the free numbers to the nearest local minimum. Whole numbers stay.
FoundMechanism refine_mechanism(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
                                const std::vector<double>& values);

/// CIEDE2000 below which two answers are equally good.
inline constexpr double as_good_as_met = 0.1;

}  // namespace nacre
