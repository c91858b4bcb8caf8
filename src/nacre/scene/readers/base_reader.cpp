// `base`: what lies below the layers. The first key of its table says which kind of base it is.
#include "nacre/scene/readers/base_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "nacre/base/crop_curve.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/pick/smooth_rgb.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/metal_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_reflectance{0.0, 1.0};
constexpr Allowed allowed_scattering{1e-9, 1e6, "per um"};
constexpr Allowed allowed_wavelength{1.0, 1e6, "nm"};
// Chosen: far more than instruments give.
constexpr std::size_t most_samples = 100000;
// What a colour may be off: CIEDE2000 1 is just not told apart.
constexpr double most_ciede2000 = 1.0;

std::vector<double> read_numbers(const Table& table, std::string_view key, const Allowed& allowed) {
    const Value* value = table.find(key);
    if (value == nullptr) table.fail_missing(key, "give an array of numbers");
    return table.checked_numbers(key, *value, allowed);
}

RgbBase read_rgb(const Table& table) {
    const Where& where = table.find("rgb")->where;
    const Upsampled found = upsampled(read_rec709(table, "rgb", allowed_reflectance));
    // None of 20 000 random colours is off by more than 4e-5; if one is, it is said rather than shown.
    if (!(found.ciede2000 <= most_ciede2000)) {
        table.fail(where, "no smooth reflectance has this colour; the nearest misses by CIEDE2000 " +
                              significant_text(found.ciede2000, 2) + ", more than " + number_text(most_ciede2000) +
                              "; give a less saturated colour");
    }
    return found.base;
}

SpectrumBase read_spectrum_file(const Table& table, const Value& value, const SceneContext& context) {
    const std::string& file = table.checked_text("spectrum", value);
    const CsvKeys keys = read_csv_keys(table, true);
    SampledCurve curve = context.read_curve(file, value.where, keys);
    // Instruments see further than eyes, and their last values may be noise.
    crop_curve(curve, context.index.first_nm, context.index.last_nm);
    if (curve.value.size() > most_samples) {
        table.fail(value.where, in_quotes(file) + " has " + std::to_string(curve.value.size()) +
                                    " values over the light's range; allowed " + std::to_string(most_samples));
    }
    for (std::size_t i = 0; i < curve.value.size(); ++i) {
        if (curve.value[i] >= 0.0 && curve.value[i] <= 1.0) continue;
        const bool is_above = curve.value[i] > 1.0;
        const std::string remedy = !is_above         ? "; write negative = \"clip\" if it is noise"
                                   : keys.is_percent ? ""
                                                     : "; write unit = \"percent\" if it is percent";
        table.fail(value.where, in_quotes(file) + " has a reflectance " + (is_above ? "above 1, " : "below 0, ") +
                                    number_text(curve.value[i]) + " at " + number_text(curve.wavelength_nm[i]) +
                                    " nm; allowed [0, 1]" + remedy);
    }
    return {std::move(curve)};
}

SpectrumBase read_inline_spectrum(const Table& table) {
    SampledCurve curve{read_numbers(table, "wavelength_nm", allowed_wavelength),
                       read_numbers(table, "reflectance", allowed_reflectance)};
    if (curve.wavelength_nm.size() != curve.value.size() || curve.value.size() < 2 ||
        curve.value.size() > most_samples) {
        table.fail_at("reflectance", "wavelength_nm has " + std::to_string(curve.wavelength_nm.size()) +
                                         " numbers and reflectance " + std::to_string(curve.value.size()) +
                                         "; allowed: as many of each, 2 to " + std::to_string(most_samples));
    }
    if (std::adjacent_find(curve.wavelength_nm.begin(), curve.wavelength_nm.end(), std::greater_equal<>()) !=
        curve.wavelength_nm.end()) {
        table.fail_at("wavelength_nm", "wavelength_nm does not ascend; give every wavelength once, smallest first");
    }
    return {std::move(curve)};
}

PigmentBase read_pigment(const Table& table, const IndexReader& index) {
    PigmentBase base;
    base.pigment = read_required_index(table, "pigment", index);
    base.scattering_per_um = table.number_or("scattering_per_um", allowed_scattering, base.scattering_per_um);
    base.share = table.number_or("share", allowed_reflectance, base.share);
    return base;
}

constexpr std::string_view forms =
    "a number, { rgb }, { spectrum }, { wavelength_nm, reflectance }, { pigment, scattering_per_um, share } or "
    "{ metal }";

Base read_form(const Table& table, const SceneContext& context) {
    // One of these says which form it is.
    constexpr std::array<std::string_view, 5> leading{"rgb", "spectrum", "reflectance", "pigment", "metal"};
    std::string_view form;
    for (const std::string_view key : leading) {
        const Value* value = table.find(key);
        if (value == nullptr) continue;
        if (!form.empty()) {
            table.fail(value->where, "base has both " + std::string(form) + " and " + std::string(key) +
                                         "; give one of " + std::string(forms));
        }
        form = key;
    }
    if (form.empty() && table.find("wavelength_nm") != nullptr) form = "reflectance";
    if (form == "rgb") return read_rgb(table);
    if (form == "spectrum") return read_spectrum_file(table, *table.find("spectrum"), context);
    if (form == "reflectance") return read_inline_spectrum(table);
    if (form == "pigment") return read_pigment(table, context.index);
    if (form == "metal") return MetalBase{read_required_index(table, "metal", context.index)};
    for (const std::string_view key : {"scattering_per_um", "share"}) table.skip(key);
    table.expect_all_read();
    if (table.is_good()) table.note(table.where(), "base does not say what it is; give " + std::string(forms));
    return GreyBase{};
}

std::optional<Base> read_value(const Table& table, const Value& value, const SceneContext& context) {
    if (const auto* word = std::get_if<std::string>(&value.data)) {
        if (*word == "black") return {};
        table.fail(value.where, "unknown base " + in_quotes(*word) + "; known: black, " + std::string(forms));
    }
    if (std::holds_alternative<std::shared_ptr<Table>>(value.data)) {
        const Table& form = table.checked_table("base", value);
        const Base base = read_form(form, context);
        form.expect_all_read();
        return base;
    }
    if (!std::holds_alternative<double>(value.data) && !std::holds_alternative<std::int64_t>(value.data)) {
        table.fail(value.where, "base = " + value.text() + " is " + std::string(value.kind()) + "; give black, " +
                                    std::string(forms));
    }
    return GreyBase{table.checked_number("base", value, allowed_reflectance)};
}

std::string list_text(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
    return "[" + text + "]";
}

struct BaseText {
    std::string operator()(const GreyBase& base) const { return number_text(base.reflectance); }
    std::string operator()(const RgbBase& base) const {
        return "{ rgb = " + list_text({base.rgb.begin(), base.rgb.end()}) + " }";
    }
    std::string operator()(const SpectrumBase& base) const {
        return "{ wavelength_nm = " + list_text(base.reflectance.wavelength_nm) +
               ", reflectance = " + list_text(base.reflectance.value) + " }";
    }
    std::string operator()(const PigmentBase& base) const {
        return "{ pigment = " + index_toml(base.pigment) +
               ", scattering_per_um = " + number_text(base.scattering_per_um) + ", share = " + number_text(base.share) +
               " }";
    }
    std::string operator()(const MetalBase& base) const { return "{ metal = " + index_toml(base.metal) + " }"; }
};

}  // namespace

std::optional<Base> read_base(const Table& table, const SceneContext& context) {
    const Value* value = table.find("base");
    if (value == nullptr) return {};
    std::optional<Base> base;
    attempt(table, value->where, [&] { base = read_value(table, *value, context); });
    return base;
}

std::string base_toml(const Base& base) {
    return std::visit(BaseText{}, base);
}

}  // namespace nacre
