// [light]: the illuminant, the eye, and the wavelengths that count.
#include "nacre/scene/readers/light_reader.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "nacre/base/crop_curve.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/cie_tables.h"
#include "nacre/colour/illuminant.h"
#include "nacre/scene/catalogue.h"

namespace nacre {
namespace {

constexpr Allowed allowed_nm{cie_table_first_nm, cie_table_last_nm, "nm"};
constexpr Allowed any_power{0.0, 1e30};
constexpr Allowed any_wavelength{1.0, 1e6, "nm"};
constexpr std::size_t most_light_samples = 100000;  // chosen: far more than instruments give

void read_range(const Table& table, LightSettings& settings) {
    const Value* range = table.find("range_nm");
    if (range == nullptr) return;
    const Value::Array& ends = table.checked_array("range_nm", *range);
    if (ends.size() != 2)
        table.fail(range->where, "range_nm has " + std::to_string(ends.size()) + " numbers; give [first, last]");
    settings.first_nm = table.checked_integer("range_nm", ends[0], allowed_nm);
    settings.last_nm = table.checked_integer("range_nm", ends[1], allowed_nm);
    if (table.is_good() && settings.first_nm >= settings.last_nm) {
        table.fail(range->where, "range_nm = [" + std::to_string(settings.first_nm) + ", " +
                                     std::to_string(settings.last_nm) + "] is empty; give the smaller number first");
    }
}

// { name = "...", wavelength_nm = [...], power = [...] }: what light_toml() writes for a table.
SampledCurve read_inline_curve(const Table& table) {
    const auto numbers = [&](std::string_view key, const Allowed& allowed) {
        const Value* value = table.find(key);
        if (value == nullptr) table.fail_missing(key, "give an array of numbers");
        return table.checked_numbers(key, *value, allowed);
    };
    SampledCurve curve{numbers("wavelength_nm", any_wavelength), numbers("power", any_power)};
    if (curve.wavelength_nm.size() != curve.value.size() || curve.value.size() < 2 ||
        curve.value.size() > most_light_samples) {
        table.fail(table.where(), "wavelength_nm has " + std::to_string(curve.wavelength_nm.size()) +
                                      " numbers and power " + std::to_string(curve.value.size()) +
                                      "; allowed: as many of each, 2 to " + std::to_string(most_light_samples));
    }
    if (std::adjacent_find(curve.wavelength_nm.begin(), curve.wavelength_nm.end(), std::greater_equal<>()) !=
        curve.wavelength_nm.end()) {
        table.fail_at("wavelength_nm", "wavelength_nm does not ascend; give every wavelength once, smallest first");
    }
    return curve;
}

// A file is known by its name, and one of its columns by both names.
void read_lamp_file(const std::string& file, const Where& where, const CsvKeys& keys, const CurveReader& read_curve,
                    LightSettings& settings) {
    settings.power = read_curve(file, where, keys);
    settings.illuminant = file.substr(file.find_last_of("/\\") + 1) + (keys.column.empty() ? "" : " " + keys.column);
    settings.is_table = true;
}

void read_illuminant(const Table& table, LightSettings& settings, const CurveReader& read_curve) {
    const Value* value = table.find("illuminant");
    if (value == nullptr) {
        settings.power = *illuminant_by_name(settings.illuminant);
        return;
    }
    if (std::holds_alternative<std::shared_ptr<Table>>(value->data)) {
        const Table& inline_table = table.checked_table("illuminant", *value);
        settings.is_table = true;
        if (const Value* file = inline_table.find("file")) {
            read_lamp_file(inline_table.checked_text("file", *file), file->where, read_csv_keys(inline_table, false),
                           read_curve, settings);
        } else {
            settings.illuminant = inline_table.text_or("name", "table");
            settings.power = read_inline_curve(inline_table);
        }
        inline_table.expect_all_read();
        return;
    }
    const std::string& name = table.checked_text("illuminant", *value);
    if (auto power = illuminant_by_name(name)) {
        settings.illuminant = name;
        settings.power = std::move(*power);
        return;
    }
    if (!name.ends_with(".csv") && !name.ends_with(".CSV")) {
        std::vector<std::string> known;
        for (const std::string_view illuminant : illuminant_names()) known.emplace_back(illuminant);
        table.fail(value->where, "unknown illuminant " + in_quotes(name) + "; known: " + comma_separated(known) +
                                     ", or the name of a .csv file of wavelength_nm,power");
    }
    read_lamp_file(name, value->where, {}, read_curve, settings);
}

// Before the table is cropped: the message names the range of the file.
void check_covers(const Table& table, const LightSettings& settings) {
    const std::vector<double>& nm = settings.power.wavelength_nm;
    if (nm.front() <= settings.first_nm && nm.back() >= settings.last_nm) return;
    table.fail_at("illuminant", "illuminant " + in_quotes(settings.illuminant) + " covers " + number_text(nm.front()) +
                                    " to " + number_text(nm.back()) + " nm; range_nm needs " +
                                    std::to_string(settings.first_nm) + " to " + std::to_string(settings.last_nm) +
                                    " nm");
}

// A table of the user's may be anything: it must have light in it, and a white that can be adapted.
void check_power(const Table& table, const LightSettings& settings) {
    const auto& [nm, power] = settings.power;
    const auto fail = [&](const std::string& message) {
        table.fail_at("illuminant", "illuminant " + in_quotes(settings.illuminant) + " " + message);
    };
    if (power.size() > most_light_samples)
        fail("has more than " + std::to_string(most_light_samples) + " values in range_nm");
    for (std::size_t i = 0; i < power.size(); ++i) {
        if (power[i] >= any_power.low && power[i] <= any_power.high) continue;
        fail("is " + number_text(power[i]) + " at " + number_text(nm[i]) + " nm; power is 0 to " +
             number_text(any_power.high) +
             (power[i] < 0.0 ? "; write { file = \"NAME\", negative = \"clip\" } if it is noise" : ""));
    }
    // Linear between its nodes, a lamp has light if it has some at a node inside, or at an end.
    double light = settings.power.at(settings.first_nm) + settings.power.at(settings.last_nm);
    for (std::size_t i = 0; i < power.size(); ++i) {
        if (nm[i] > settings.first_nm && nm[i] < settings.last_nm) light += power[i];
    }
    if (!(light > 0.0)) fail("has no visible light in range_nm; give it power there, or widen range_nm");
}

}  // namespace

LightSettings read_light(const Table* light, std::optional<int> wavelengths, const CurveReader& read_curve) {
    const Table defaults("light", {});
    const Table& table = light == nullptr ? defaults : *light;
    LightSettings settings;
    settings.wavelengths = wavelengths;
    settings.observer = read_word(table, "observer", "observer", observer_words);
    settings.adaptation = read_word(table, "adapt", "adapt", adaptation_words);
    attempt(table, table.where(), [&] { read_range(table, settings); });
    attempt(table, table.where(), [&] { read_illuminant(table, settings, read_curve); });
    table.expect_all_read();
    if (settings.is_table && table.is_good()) {
        attempt(table, table.where(), [&] {
            check_covers(table, settings);
            // Lamps are measured further than eyes see, and their last values may be noise below zero.
            crop_curve(settings.power, settings.first_nm, settings.last_nm);
            check_power(table, settings);
        });
    }
    return settings;
}

std::string light_toml(const LightSettings& settings) {
    std::string illuminant;
    if (settings.is_table) {
        const auto list = [](const std::vector<double>& numbers) {
            std::string text;
            for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
            return "[" + text + "]";
        };
        illuminant = "{ name = " + toml_string(settings.illuminant) +
                     ", wavelength_nm = " + list(settings.power.wavelength_nm) +
                     ", power = " + list(settings.power.value) + " }";
    } else {
        illuminant = toml_string(settings.illuminant);
    }
    return "[light]\nilluminant = " + illuminant +
           "\nobserver = " + toml_string(name_of(observer_words, settings.observer)) +
           "\nadapt = " + toml_string(name_of(adaptation_words, settings.adaptation)) + "\nrange_nm = [" +
           std::to_string(settings.first_nm) + ", " + std::to_string(settings.last_nm) + "]\n";
}

}  // namespace nacre
