#pragma once

#include <string>
#include <vector>

#include "nacre/lut/axis.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"
#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// The parts of a session's answers, as page/api.ts has them.

/// Every value of a text by its path; an empty object if it is not TOML.
Json values_json(const std::string& text);
/// A message of one or more lines, "scene.toml:3:5 ...: ..." each.
Json mistakes_json(const std::string& message);
Json material_json(const SceneMaterial& material, const Light& light);
Json lut_summary_json(const PlannedLut& lut);
/// A LUT with what its bake has found, and a warning if its bound, which is the default, is out of reach.
Json baked_json(const DecidedLut& decided, const BakedLut& baked);
/// Seconds of one thread.
Json seconds_json(const DecidedLut& decided, const BakedLut& baked);

/// Linear Rec.709 of XYZ relative to D65.
Rgb in_rec709(const Xyz& colour);

/// Size of a LUT's EXR file.
std::size_t exr_bytes(const DecidedLut& decided, const BakedLut& baked);

}  // namespace nacre
