#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/loaded_scene.h"
#include "cli/settled_luts.h"
#include "io/disk/output_folder.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

/// One LUT or one swatch of one scene.
struct BakeTask {
    const LoadedScene* scene = nullptr;
    const PlannedLut* lut = nullptr;        ///< null for a swatch
    const PlannedSwatch* swatch = nullptr;  ///< null for a LUT
    std::size_t swatch_index = 0;
    const SettledTask* settled = nullptr;  ///< of a LUT, once it is

    const std::string& name() const { return lut != nullptr ? lut->name : swatch->name; }
    const Where& where() const { return lut != nullptr ? lut->where : swatch->where; }
    /// Whether it is lettered, or holds a picture that is.
    bool draws_picture() const;
};

/// Where files go, and what pictures are lettered with.
struct BakeTarget {
    OutputFolder& folder;
    std::filesystem::path font;  ///< empty if there is no picture to draw
    bool force = false;          ///< writes what is there already
    bool best_effort = false;    ///< writes LUTs that miss their bound
};

/// What became of a task.
struct BakeOutcome {
    std::string line;             ///< for people
    nlohmann::ordered_json json;  ///< for machines
    std::string failure;          ///< why it was not written; empty if it was
    std::string warning;          ///< what else should be known; empty if nothing
    bool misses_bound = false;    ///< measured, the LUT errs by more than its binding bound, which settle() found kept
    std::size_t outside_gamut = 0;
    bool unchanged = false;
};

/// Bakes, measures, encodes and hands the files to the target's folder, which commits them later.
///
/// A LUT's own failure is an outcome; a refusal of the system is thrown.
BakeOutcome run_bake_task(const BakeTask& task, const BakeTarget& target);

}  // namespace nacre
