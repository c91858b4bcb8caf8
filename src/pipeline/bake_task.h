#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
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

enum class TaskKind { lut, preview, swatch };

/// One LUT, the preview of one, or one swatch of one scene.
struct BakeTask {
    TaskKind kind = TaskKind::lut;
    const LoadedScene* scene = nullptr;
    const PlannedLut* lut = nullptr;        ///< of a preview the LUT that it shows; null for a swatch
    const PlannedSwatch* swatch = nullptr;  ///< null unless it is one
    const ColourSpace* display = nullptr;   ///< of a preview or swatch
    /// Of a LUT, once it is decided; decided again if the LUT errs by more than its bound.
    DecidedLut* decided = nullptr;

    bool is_lut() const { return kind == TaskKind::lut; }
    const std::string& name() const { return lut != nullptr ? lut->name : swatch->name; }
    /// Name of the file of a picture. @pre it is no LUT
    std::string picture() const;
    const Where& where() const { return lut != nullptr ? lut->where : swatch->where; }
    /// What a picture shows. @pre it is no LUT
    SwatchKind draws() const { return kind == TaskKind::preview ? SwatchKind::preview : swatch->kind; }
    /// Whether it is a preview that nobody asked for.
    bool is_automatic() const { return kind == TaskKind::preview && lut->preview == Preview::automatic; }
};

/// Everything that the scenes ask for, scene by scene, LUTs before swatches, each preview behind its LUT. Refers to the
/// scenes.
/// @param with_luts  false: pictures only
/// @pre the default display of a scene whose LUTs have previews is open
std::vector<BakeTask> bake_tasks(const std::vector<LoadedScene>& scenes, bool with_luts);

/// Where files go, and what pictures are lettered with.
struct BakeTarget {
    OutputFolder& folder;
    std::filesystem::path font;  ///< empty if there is no preview and no swatch to draw
    bool force = false;          ///< writes what is there already
    bool best_effort = false;    ///< writes LUTs that miss their bound
};

/// What became of a task.
struct BakeOutcome {
    std::string failure;        ///< why it was not written; empty if it was
    std::string warning;        ///< what else should be known; empty if nothing
    bool is_refused = false;    ///< the failure is one of the system, not of the scene
    bool is_left_out = false;   ///< an automatic preview that could not be drawn; the warning says why
    bool misses_bound = false;  ///< measured, the LUT errs by more than its binding bound, which was predicted to hold
    bool unchanged = false;     ///< all files were there already with the same bytes
    BakedLut baked;             ///< of a LUT, without its image and its header
    Json manifest;              ///< of a LUT
    std::optional<std::size_t> png_clamped;  ///< of a LUT with a PNG: texels that the display cannot show
    double seconds = 0.0;                    ///< of a LUT: computed, converted, measured, encoded, on one thread
};

/// Bakes, measures, encodes and hands the files to the target's folder, which commits them later.
///
/// A LUT that errs by more than its bound, though it was predicted to keep it, is chosen again more carefully and baked
/// again, up to three times.
///
/// A LUT's own failure is an outcome, and so is that of a picture; a refusal of the disk is thrown.
BakeOutcome run_bake_task(const BakeTask& task, const BakeTarget& target, const Execution& execution);

/// Runs all tasks and commits their files, some hundred tasks at a time.
/// @param on_outcome  called in the order of the tasks, from the calling thread, once a task's files are in place
void bake_all(const std::vector<BakeTask>& tasks, const BakeTarget& target, const Execution& execution,
              const std::function<void(const BakeTask& task, const BakeOutcome& outcome)>& on_outcome);

}  // namespace nacre
