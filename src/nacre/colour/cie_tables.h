#pragma once

#include <array>
#include <span>
#include <string_view>

namespace nacre {

/// The observers' tables: rows of { x_bar, y_bar, z_bar }, one per nanometre from `cie_table_first_nm`.
inline constexpr int cie_table_first_nm = 360;
inline constexpr int cie_table_last_nm = 830;
inline constexpr int cie_table_count = cie_table_last_nm - cie_table_first_nm + 1;

extern const std::array<std::array<double, 3>, cie_table_count> cie1931_2deg_table;
extern const std::array<std::array<double, 3>, cie_table_count> cie1964_10deg_table;

/// Relative spectral power at first_nm, first_nm + step_nm, ...; any scale.
struct CieIlluminantTable {
    std::string_view name;
    int first_nm;
    int step_nm;
    std::span<const double> power;
};

/// The illuminants that are compiled in, in the order in which they are offered.
extern const std::array<CieIlluminantTable, 9> cie_illuminant_tables;

}  // namespace nacre
