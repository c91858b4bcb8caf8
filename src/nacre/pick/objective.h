#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/light.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/shown_colours.h"

namespace nacre {

/// Values of the free numbers, as places in their ranges, each in [0, 1].
using Design = std::vector<double>;

/// A design and its error: the root of the weighted mean of the squares of CIEDE2000 to the requested colours; infinity
/// if they are not finite.
struct Rated {
    Design design;
    double error = 0.0;
};

inline bool is_better(const Rated& one, const Rated& other) {
    return one.error < other.error;
}

/// Whether designs are likely near the same local minimum: each place differs by 0.04 at most.
bool are_near(const Design& one, const Design& other);

/// The objective of a search: the errors of designs, and local refinement.
class Objective {
public:
    /// All have to outlive this.
    Objective(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve);

    Mechanism mechanism_of(const Design& design) const;
    /// The part of a design that least squares cannot change.
    std::vector<double> whole_numbers(const Design& design) const;
    /// With whole numbers in the middle of the places that they have: designs that differ within those are one.
    Design rounded(Design design) const;

    Rated rated(const Design& design, SearchDetail detail);
    /// Refines a design locally: a few steps with the detail of the table, else to convergence with the detail of the
    /// report. Whole numbers stay.
    Rated refined(const Design& start, SearchDetail detail);
    /// The same from a local minimum, with as many nodes as its spectra need, because coarse nodes miss narrow
    /// resonances.
    Rated refined_with_own_nodes(const Design& start);
    /// Everything that is reported of an answer, with the detail of a report.
    FoundMechanism judged(const Design& design);
    /// How far its colours move when its free thicknesses are inexact. @pre one is free
    Tolerance tolerance_of(const FoundMechanism& found);

private:
    struct Converged {
        std::vector<Xyz> shown;
        int times = 1;  ///< of the report's nodes that this takes
    };
    Converged converged_colours(const Mechanism& mechanism, double converged_de00, int most_times);
    Rated descended(const Design& start, const SearchSampling& sampling, int steps) const;
    double error_of(std::span<const Xyz> shown) const;
    std::vector<std::size_t> moving_numbers() const;
    void fill(std::span<const Xyz> shown, std::span<double> residuals) const;

    const MechanismSearch& search_;
    const LeastSquaresSolver& solve_;
    ShownColours shown_;
    std::vector<Lab> wanted_;
    double total_weight_ = 0.0;
};

}  // namespace nacre
