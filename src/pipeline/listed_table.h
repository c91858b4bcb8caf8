#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// The numbers behind a name of a list: what a CIE table says.
struct ListedTable {
    std::vector<std::string> columns;       ///< "wavelength_nm", ...
    std::vector<std::vector<double>> rows;  ///< as many numbers as columns, wavelengths ascending
};

/// Of an illuminant: wavelength_nm,power at the table's own wavelengths, the form that `illuminant` of [light] reads.
/// Of an observer: wavelength_nm,x_bar,y_bar,z_bar.
/// @throws Error if the list has no tables, or no such name
ListedTable listed_table(std::string_view list, std::string_view name);

}  // namespace nacre
