#pragma once

#include <optional>
#include <string>

#include "nacre/optics/measured_spectra.h"
#include "nacre/scene/table.h"

namespace nacre {

/// What a scene says about a CSV table that it names, beside its file.
struct CsvKeys {
    bool is_reflectance = false;  ///< whether values may be percent
    std::string column{};         ///< the heading of the specimen's column; empty: the table is not one of specimens
    std::optional<bool> is_percent{};  ///< nothing: not said, so fractions
    bool clips_negative = false;       ///< whether small negative values count as 0
};

/// `column`, `unit` (of reflectance only) and `negative`, from the table that names the file.
CsvKeys read_csv_keys(const Table& table, bool is_reflectance);

/// `unit`: "percent" or "fraction".
std::optional<bool> read_is_percent(const Table& table);

/// Warns of more light than a white standard has, unless the scene says the unit.
void warn_of_bright_spectra(const Table& table, const Where& where, const MeasuredSpectra& spectra,
                            std::optional<bool> is_percent);

}  // namespace nacre
