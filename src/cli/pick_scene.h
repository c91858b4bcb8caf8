#pragma once

#include <string>
#include <vector>

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

/// One pick, as a scene has it.
struct PickLine {
    std::string toml;     ///< "{ angle_deg = 0, colour = \"#3a6fd0\" }"
    std::string comment;  ///< behind it; may be empty
};

/// The arguments COLOUR@ANGLE as picks. Throws Error for one that is none.
std::vector<PickLine> pick_lines(const PickOptions& options);

/// Refuses what --with has that is no key and value, or one that it has twice. Throws Error.
void check_with(const std::vector<std::string>& with);

/// A scene of one material and its swatches.
/// @param material  its lines, but for the picks
/// @param picks     the value of `picks`; empty: no such key
/// @param comments  lines above the material; may be empty
std::string pick_scene(const PickOptions& options, const std::string& material, const std::string& picks,
                       const std::string& comments, bool has_colours);

/// "[\n    { ... },  # comment\n]"
std::string picks_toml(const std::vector<PickLine>& picks);

}  // namespace nacre
