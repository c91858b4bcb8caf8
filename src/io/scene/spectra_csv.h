#pragma once

#include <string>

#include "nacre/optics/measured_spectra.h"
#include "nacre/scene/readers/csv_keys.h"

namespace nacre {

/// A table of spectra at several angles: a heading of wavelengths (see csv_table.h), then one angle per column, in
/// degrees and in any order ("15", "15 deg", "15°" or "R_15"); then a row per wavelength. If the keys name a column,
/// its heading is a specimen's name, and the only angle is 0.
///
/// The result satisfies the conditions of MeasuredSpectra; its `file` is the path. Reflectance is a fraction of what a
/// white standard has, [0, 10]. Throws IoError, or Error with the line and column.
MeasuredSpectra read_spectra_csv(const std::string& path, const CsvKeys& keys = {.is_reflectance = true});

}  // namespace nacre
