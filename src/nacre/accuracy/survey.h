#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/accuracy/care.h"
#include "nacre/accuracy/choose_effects.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/error_split.h"
#include "nacre/accuracy/model_curve.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// Where the error of turning spectra into colours shows.
enum class SpectrumError {
    in_scan,      ///< the model is the true integral, so that a scan of the LUT finds it
    beside_scan,  ///< LUT and model have it alike: it comes on top of what a scan finds, and the bound has to cover it
    not_judged,   ///< likewise, but the scene requests its wavelengths and gives no bound: it is reported only
};

/// What is known of a LUT before a size is tried. Nothing in it changes afterwards.
struct LutSurvey {
    PlannedLut lut;                     ///< sampling and effects are chosen; size and format are open
    std::vector<EffectChoice> effects;  ///< those of the material, and what became of each
    ErrorSplit known;                   ///< what no size helps against: spectrum, spread, quadrature, effects
    SpectrumError spectrum_error = SpectrumError::in_scan;
    double scale = 1.0;                       ///< how many times brighter the LUT is shown
    std::shared_ptr<const ModelCurve> curve;  ///< the colours of a 1D LUT, where they are expensive; null: none
    Effort effort;                            ///< what the search may take
    double share_of_texels = 1.0;             ///< see Care
    std::shared_ptr<NodeMaker> nodes;         ///< of the job's light

    bool is_2d() const { return lut.job.y.has_value(); }
};

/// @param can_judge   whether the colour space has an inverse, so that errors in it can be known; else all effects stay
///                    and nothing but the sampling is found
/// @param care        how much more careful than usual the LUT is chosen
/// @param after_step  called every few colours; what it throws ends the survey
/// @param work        what it takes is added
LutSurvey survey_lut(const PlannedLut& lut, bool can_judge, const Care& care, const AfterRow& after_step, Work& work);

/// What nodes may err by at probes.
double tolerance_of_nodes(double max_de00);

/// What every sum may err by, where no effect is left out.
SamplingTolerance sampling_tolerance(double max_de00);

/// The part of the bound that an error may fill which a scan finds.
double scannable_bound(const LutSurvey& survey);

/// The largest error that a scan of a LUT may find. Errors that no larger LUT helps against are taken off up to a part
/// of the bound only: beyond it the LUT cannot keep the bound, but is still the best for its bytes.
double scan_limit(const LutSurvey& survey);

/// The error of a LUT in which a scan found `scanned`.
double total_error(const LutSurvey& survey, double scanned);

/// The same, of what the bound has to cover.
double judged_error(const LutSurvey& survey, double scanned);

/// Points at which a LUT's colours are surveyed.
inline constexpr int survey_columns = 65;
inline constexpr int survey_rows = 9;

/// What effects that are left out may take of a bound, all of them together.
inline constexpr double share_of_effects = 0.1;

}  // namespace nacre
