#pragma once

#include <string>
#include <vector>

#include "pipeline/pick_scene.h"

namespace nacre {

/// What `nacre pick` was given.
struct PickOptions {
    std::vector<std::string> picks;
    std::string measured;           ///< a CSV of spectra; empty: none
    int count = 0;                  ///< of picks that stand for the spectra; 0: not given
    std::string mechanism;          ///< empty: palette
    std::vector<std::string> with;  ///< lines of the material, "index = 1.33"
    int choose = 0;                 ///< which answer, from 1; 0: not given
    std::string space;
    std::string name = "picked";
    std::string ocio;
    std::string swatch;  ///< a PNG that is to be written; empty: none
    bool strict = false;
};

/// The arguments COLOUR@ANGLE as picks. Throws Error for one that is none.
std::vector<PickLine> pick_lines(const PickOptions& options);

/// Refuses what --with has that is no key and value, or one that it has twice. Throws Error.
void check_with(const std::vector<std::string>& with);

}  // namespace nacre
