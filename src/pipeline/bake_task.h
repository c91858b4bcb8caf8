#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/disk/output_folder.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/planned_swatch.h"
#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/execution.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// One LUT or one swatch of one scene.
struct BakeTask {
    const LoadedScene* scene = nullptr;
    const PlannedLut* lut = nullptr;        ///< null for a swatch
    const PlannedSwatch* swatch = nullptr;  ///< null for a LUT
    std::size_t swatch_index = 0;
    const DecidedLut* decided = nullptr;  ///< of a LUT, once it is

    const std::string& name() const { return lut != nullptr ? lut->name : swatch->name; }
    const Where& where() const { return lut != nullptr ? lut->where : swatch->where; }
    /// Whether it is lettered, or holds a picture that is.
    bool draws_picture() const;
};

/// Everything that the scenes ask for, scene by scene, LUTs before swatches. Refers to the scenes.
/// @param with_luts  false: swatches only
std::vector<BakeTask> bake_tasks(const std::vector<LoadedScene>& scenes, bool with_luts);

/// Where files go, and what pictures are lettered with.
struct BakeTarget {
    OutputFolder& folder;
    std::filesystem::path font;  ///< empty if there is no picture to draw
    bool force = false;          ///< writes what is there already
    bool best_effort = false;    ///< writes LUTs that miss their bound
};

/// What became of a task.
struct BakeOutcome {
    std::string failure;        ///< why it was not written; empty if it was
    std::string warning;        ///< what else should be known; empty if nothing
    bool misses_bound = false;  ///< measured, the LUT errs by more than its binding bound, which was predicted to hold
    bool unchanged = false;     ///< all files were there already with the same bytes
    BakedLut baked;             ///< of a LUT, without its image and its header
    Json manifest;              ///< of a LUT
    double seconds = 0.0;       ///< of a LUT: computed, converted, measured, encoded, on one thread
};

/// Bakes, measures, encodes and hands the files to the target's folder, which commits them later.
///
/// A LUT's own failure is an outcome; a refusal of the system is thrown.
BakeOutcome run_bake_task(const BakeTask& task, const BakeTarget& target, const Execution& execution);

/// Runs all tasks and commits their files, some hundred tasks at a time.
/// @param on_outcome  called in the order of the tasks, from the calling thread, once a task's files are in place
void bake_all(const std::vector<BakeTask>& tasks, const BakeTarget& target, const Execution& execution,
              const std::function<void(const BakeTask& task, const BakeOutcome& outcome)>& on_outcome);

}  // namespace nacre
