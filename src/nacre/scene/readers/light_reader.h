#pragma once

#include <functional>
#include <optional>
#include <string>

#include "nacre/base/sampled_curve.h"
#include "nacre/base/where.h"
#include "nacre/colour/light.h"
#include "nacre/scene/readers/csv_keys.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Reads a curve over wavelength for the core. The front end finds the file beside the scene; a curve that comes
/// back ascends and is finite. Throws Error or IoError.
using CurveReader = std::function<SampledCurve(const std::string& file, const Where& where, const CsvKeys& keys)>;

/// Reads [light] (null: all defaults) and `wavelengths` of [accuracy]. Notes mistakes; what comes back can be used only
/// if the table is good.
LightSettings read_light(const Table* light, std::optional<int> wavelengths, const CurveReader& read_curve);

/// The [light] table that leads to these settings; a table of spectral power is written out in full.
std::string light_toml(const LightSettings& settings);

}  // namespace nacre
