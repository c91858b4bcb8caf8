#pragma once

#include <string>
#include <vector>

#include "nacre/base/sampled_curve.h"

namespace nacre {

/// One row of a table of refractive indices. What the table does not give is 0.
struct IndexRow {
    int line = 0;
    double wavelength_nm = 0.0;
    double n = 0.0;
    double k = 0.0;
};

/// A table as written by the user.
struct IndexTable {
    bool gives_n = false;
    bool gives_k = false;
    std::vector<IndexRow> rows;  ///< in any order
};

/// The same, ascending; a curve that the table does not give has no nodes.
struct IndexCurves {
    SampledCurve n;
    SampledCurve k;
};

/// Sorts the rows by wavelength, and merges equal duplicates.
///
/// Throws Error, `file:line: what is wrong; what is allowed`, for a wavelength <= 0, n <= 0, k < 0 (gain), a wavelength
/// that is given twice with different values, and a table without rows.
/// @param line  of the table, for what is wrong with all of it
IndexCurves index_curves(IndexTable table, const std::string& file, int line);

/// A CSV of wavelength_nm,n or wavelength_nm,n,k (see csv_table.h); or that of refractiveindex.info, whose wavelengths
/// are micrometres under the heading `wl`, with a block for n and one for k, each with a heading. One table per block,
/// not checked by index_curves() yet.
///
/// Throws IoError, or Error for anything else than two or three columns of numbers, and for a table that ends below 100
/// nm: its wavelengths are micrometres.
std::vector<IndexTable> read_index_csv(const std::string& path);

}  // namespace nacre
