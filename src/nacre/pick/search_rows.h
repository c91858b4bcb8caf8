#pragma once

#include "nacre/material/mechanism.h"
#include "nacre/pick/find_mechanism.h"

namespace nacre {

/// How a mechanism is searched for: one row each.
struct SearchRow {
    SearchEffort effort;  ///< for many free numbers
    /// See complexity_of(); null: it is never searched for.
    double (*complexity)(const Mechanism&);
};

SearchRow search_row_of(const Mechanism& mechanism);

/// The complexity of a mechanism: layers, planes or grooves first, then nanometres. Smaller is simpler; only
/// mechanisms of one kind compare. 0 for what is never searched for.
double complexity_of(const Mechanism& mechanism);

}  // namespace nacre
