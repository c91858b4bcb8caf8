#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/execution.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// One LUT of one scene, and what was decided about it.
struct DecidedLut {
    const LoadedScene* scene = nullptr;
    const PlannedLut* asked = nullptr;
    ChosenLut lut;
    double seconds = 0.0;  ///< what deciding took, of one thread
    std::string failure;   ///< why nothing could be decided; empty if it could

    const ColourSpace& space() const { return scene->space_of(asked->colour); }
    /// Whether a bound was given or is the default, errors can be known, and the bound is out of reach.
    bool is_out_of_reach() const;
};

/// What a user who asked for more than there is should know: the best that was reached, and what stands in the way.
std::string out_of_reach(const ChosenLut& lut);

/// What a front end says about accuracy beside the scenes.
struct AccuracyOverride {
    std::optional<double> max_de00;        ///< a binding bound for every LUT
    std::optional<bool> may_drop_effects;  ///< whether effects that change nothing that counts are left out
};

/// Writes it into every LUT of the scenes.
///
/// Throws Error if a bound is binding, the scene's own too, in a colour space in which errors cannot be known.
void override_accuracy(std::vector<LoadedScene>& scenes, const AccuracyOverride& accuracy);

/// The LUTs of the scenes, nothing decided yet. Refers to the scenes.
std::vector<DecidedLut> undecided_luts(const std::vector<LoadedScene>& scenes);

/// Decides size, format and sampling of the LUTs; those of a pair together, even if only one of them is wanted.
void decide_all(std::vector<DecidedLut>& luts, const Execution& execution);

}  // namespace nacre
