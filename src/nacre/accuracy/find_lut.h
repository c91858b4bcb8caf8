#pragma once

#include <memory>
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
    std::shared_ptr<Trial> trial;  ///< of that size and format
    bool is_reached = false;       ///< whether the bound is kept
    /// Where the colour jumps, or turns so sharply that no texture can follow.
    std::optional<LutPoint> jump{};
};

/// The cheapest LUT that keeps the bound; if there is none, the best that a search of limited effort finds.
/// @param work  what it takes is added; what was spent before counts too
FoundLut find_lut(const LutSearch& search, Work& work);

}  // namespace nacre
