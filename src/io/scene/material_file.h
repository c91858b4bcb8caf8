#pragma once

#include <string>
#include <string_view>

#include "nacre/optics/refractive_index.h"

namespace nacre {

/// Reads a material: a file of refractiveindex.info as it is (.yml, .yaml), or a table wavelength_nm,n[,k] (.csv).
///
/// At most 16 MB (.csv: 64 MB) and 1 000 000 rows. Throws IoError for a file that cannot be read, Error for anything in
/// it that is wrong: `file:line: what is wrong; what is allowed`.
/// @param path  as the user gave it; messages show it so
IndexCurve read_material_file(const std::string& path);

/// Reads the YAML of refractiveindex.info: DATA, a list of blocks
/// - formula 1 to formula 9 with wavelength_range (range in older files; micrometres) and coefficients, n;
/// - tabulated n, tabulated k, tabulated nk with data, rows of a wavelength in micrometres and values.
///
/// One block gives n and at most one other k; without one k is 0. The material is known in the range where both are. A
/// formula beside a tabulated nk counts for n, and the table for k. Rows may be in any order; a wavelength that is
/// given twice counts once if its values are equal. All keys beside DATA are ignored, and so are formulas within them:
/// those describe other properties.
///
/// Throws Error: see index_curves() and parse_yaml(), and for unknown types and keys, too few or too many coefficients,
/// a formula that is not finite or not above 0 somewhere in its range (tried every nanometre, at 100 000 places at
/// most), k without n, n or k given twice.
/// @param name  of the file, for messages; without its folders it becomes the curve's name
IndexCurve parse_material_yaml(std::string_view text, const std::string& name);

}  // namespace nacre
