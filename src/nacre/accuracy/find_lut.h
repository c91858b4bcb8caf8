#pragma once

#include <optional>
#include <vector>

#include "nacre/accuracy/candidates.h"
#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/survey.h"
#include "nacre/accuracy/trial.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"

namespace nacre {

/// What every step of a search for a LUT needs. All of it has to outlive the search.
struct LutSearch {
    const LutSurvey& survey;
    const Encoding& encoding;
    const AfterRow& after_step;
    TexelsOfWidths* known = nullptr;  ///< of the LUTs that are tried; null: none are kept
};

/// A size and format with what is known of their error.
struct FoundLut {
    Candidate candidate;
    Scan scan;
    double storage_error = 0.0;
    bool is_reached = false;  ///< whether the bound is kept
};

/// Bakes a candidate, to be compared with the model.
Trial try_candidate(const LutSearch& search, const Candidate& candidate);

/// The cheapest LUT that keeps the bound; if there is none, the best that a search of limited effort finds.
/// @param work  what it takes is added; what was spent before counts too
FoundLut find_lut(const LutSearch& search, Work& work);

}  // namespace nacre
