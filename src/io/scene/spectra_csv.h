#pragma once

#include <string>

#include "nacre/optics/measured_spectra.h"

namespace nacre {

/// A table of spectra at several angles: the heading `wavelength_nm`, then one angle per column, in degrees and in any
/// order ("15", "15 deg", "15°" or "R_15"); then a row per wavelength, ascending. Separators, comments and quotes as in
/// read_csv().
///
/// The result satisfies the conditions of MeasuredSpectra; its `file` is the path. Reflectance is a fraction of what a
/// white standard has, [0, 10]. Throws IoError, or Error with the line and column.
MeasuredSpectra read_spectra_csv(const std::string& path);

}  // namespace nacre
