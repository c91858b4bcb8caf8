#include "nacre/scene/readers/csv_keys.h"

#include <algorithm>
#include <array>

#include "nacre/base/text.h"
#include "nacre/scene/catalogue.h"

namespace nacre {
namespace {

constexpr std::array unit_words{Word<bool>{"fraction", false, "1 is a perfect white"},
                                Word<bool>{"percent", true, "100 is a perfect white"}};
constexpr std::array negative_words{Word<bool>{"error", false, "a negative value is a mistake"},
                                    Word<bool>{"clip", true, "noise below 0 counts as 0"}};

}  // namespace

std::optional<bool> read_is_percent(const Table& table) {
    if (table.find("unit") == nullptr) return std::nullopt;
    return read_word(table, "unit", "unit", unit_words);
}

CsvKeys read_csv_keys(const Table& table, bool is_reflectance) {
    CsvKeys keys;
    keys.is_reflectance = is_reflectance;
    keys.column = table.text_or("column", "");
    if (is_reflectance) keys.is_percent = read_is_percent(table);
    keys.clips_negative = read_word(table, "negative", "negative", negative_words);
    return keys;
}

void warn_of_bright_spectra(const Table& table, const Where& where, const MeasuredSpectra& spectra,
                            std::optional<bool> is_percent) {
    const double largest = *std::max_element(spectra.reflectance.begin(), spectra.reflectance.end());
    if (is_percent || largest <= 1.0) return;
    table.warn(where, "the reflectance reaches " + number_text(largest) +
                          ", and a white standard has 1; write unit = \"percent\" if the values are percent, or unit = "
                          "\"fraction\" if they are right");
}

}  // namespace nacre
