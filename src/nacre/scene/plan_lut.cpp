// [lut.NAME]: one LUT. Its material comes first, because the axes are the material's; then the size and the outputs.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "nacre/base/names.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_width{2, widest_lut_size, "texels"};
constexpr Allowed allowed_side{2, largest_lut_size, "texels"};
// Chosen: well below the 255 bytes of file systems, with room for suffixes.
constexpr std::size_t longest_name = 100;

Geometry from_degrees(double angle_deg) {
    return Incidence::from_degrees(angle_deg);
}

// What a fixed quantity is called, and where light and eye are at a value of it.
struct FixedKey {
    std::string_view key;
    Allowed allowed;
    Geometry (*geometry)(double);
};
FixedKey fixed_key(Quantity quantity) {
    switch (quantity) {
        case Quantity::grating_u:
            return {"grating_u", {0.0, 2.0}, Geometry::from_grating_u};
        case Quantity::cos_scatter:
            return {"cos_scatter", {-1.0, 1.0}, Geometry::from_cos_scatter};
        case Quantity::incidence:
            break;
    }
    return {"angle_deg", {0.0, 90.0, "degrees"}, from_degrees};
}

int checked_size(const Table& table, std::string_view key, const Value& value, const Allowed& allowed) {
    const int size = table.checked_integer(key, value, allowed);
    if ((size & (size - 1)) != 0) {
        table.fail(value.where, std::string(key) + " = " + std::to_string(size) +
                                    " is not a power of two; allowed 2, 4, 8 ... " +
                                    std::to_string(static_cast<int>(allowed.high)) + " (engines rescale other sizes)");
    }
    return size;
}

void check_axes_differ(const Job& job, const Table& table, const Where& where) {
    if (job.x.is_angle() && job.y->is_angle())
        table.fail(where, "x and y are both the angle; make one of them a parameter");
    if (job.x.is_angle() || job.y->is_angle()) return;
    const std::string& x = job.x.parameter.name;
    const std::string& y = job.y->parameter.name;
    const bool overlap = x == y || x.ends_with("]." + y) || y.ends_with("]." + x);
    if (overlap) table.fail(where, "x and y both set " + y + "; give two different parameters");
}

void check_relief(const Job& job, const Table& table) {
    for (const double x : {0.0, 1.0}) {
        for (const double y : {0.0, 1.0}) {
            const Relief relief = mechanism_at(job, x, y).effects.relief;
            if (relief.tilt_deg > 0.0 && relief.roughness > 0.0)
                table.fail(table.where(), std::string(two_reliefs) + "; remove one of them, or its axis");
        }
    }
}

void read_fixed_angle(const Table& table, Job& job) {
    const Quantity quantity = quantity_of(job.material.mechanism);
    const auto [key, allowed, geometry] = fixed_key(quantity);
    const Value* value = table.find(key);
    if (value == nullptr) return;
    if (job.has_angle()) {
        table.fail(value->where, std::string(key) + " is fixed, but an axis is " +
                                     (quantity == Quantity::incidence ? "the angle" : std::string(key)) +
                                     "; remove one of them");
    }
    job.fixed = geometry(table.checked_number(key, *value, allowed));
}

void read_axes(const Table& table, Job& job) {
    const Mechanism& mechanism = job.material.mechanism;
    job.x = default_axis(quantity_of(mechanism));
    const Value* x = table.find("x");
    const Value* y = table.find("y");
    if (x != nullptr) attempt(table, x->where, [&] { job.x = read_axis(table, "x", *x, mechanism); });
    if (y != nullptr) attempt(table, y->where, [&] { job.y = read_axis(table, "y", *y, mechanism); });
    if (job.y && table.is_good()) attempt(table, y->where, [&] { check_axes_differ(job, table, y->where); });
    attempt(table, table.where(), [&] { read_fixed_angle(table, job); });
    if (table.is_good()) attempt(table, table.where(), [&] { check_relief(job, table); });
}

// What is seen through layers ends at a base.
void read_quantity(const Table& table, PlannedLut& lut) {
    struct Choice {
        Observed observed;
        bool both;
    };
    constexpr std::array quantity_words{
        Word<Choice>{"reflectance", {Observed::reflectance, false}, "light that is reflected"},
        Word<Choice>{"transmittance", {Observed::transmittance, false}, "light that passes into the substrate"},
        Word<Choice>{"both", {Observed::reflectance, true}, "a LUT of each"},
    };
    const auto [observed, both] = read_word(table, "quantity", "quantity", quantity_words);
    lut.is_of_pair = both;
    Mechanism& mechanism = lut.job.material.mechanism;
    mechanism.effects.observed = observed;
    if (observed == Observed::reflectance && !both) return;
    const std::string allowed = "; allowed for a LUT of material " + in_quotes(lut.job.material.name) + ": reflectance";
    const std::string opaque = "quantity = " + in_quotes(table.text("quantity")) + " has no meaning for ";
    if (!is_layered(mechanism)) {
        table.note_at("quantity", opaque + "mechanism " + std::string(mechanism_name(mechanism)) +
                                      ", which lets no light through" + allowed);
    } else if (mechanism.effects.base) {
        table.note_at("quantity", opaque + "layers with a base, through which nothing is seen" + allowed);
    }
}

// What the LUT says itself counts instead of what [accuracy] says.
void read_request(const Table& table, const AccuracySettings& accuracy, PlannedLut& lut) {
    const bool has_y = table.find("y") != nullptr;
    AccuracySettings settings = accuracy;
    attempt(table, table.where(), [&] {
        const LutSize own = read_lut_size(table);
        if (own.height && !has_y) table.fail_at("size", "size has two numbers, but there is no y axis; give one");
        if (own.width) settings.size = {own.width, own.height ? own.height : own.width};
    });
    if (const Value* bound = table.find("max_de00"))
        settings.max_de00 = table.checked_number("max_de00", *bound, allowed_max_de00);
    AccuracyRequest request = default_request(settings, has_y);
    if (table.find("format") != nullptr) request.format = read_word(table, "format", "format", format_words);
    take_request(request, lut);
}

void read_outputs(const Table& table, PlannedLut& lut) {
    const Value* value = table.find("outputs");
    if (value == nullptr) return;
    attempt(table, value->where, [&] {
        lut.outputs.clear();
        for (const std::string& name : table.texts("outputs")) {
            const LutOutput output = meaning_of(output_words, "output", name, table, value->where);
            if (std::find(lut.outputs.begin(), lut.outputs.end(), output) == lut.outputs.end())
                lut.outputs.push_back(output);
        }
        if (lut.outputs.empty())
            table.fail(value->where, "outputs is empty; known: " + comma_separated(names_of(output_words)));
    });
}

// Where an axis may lead to.
void check_fringes_of_axes(const Table& table, const Job& job) {
    if (!job.moves_material()) return;
    for (const double x : {0.0, 1.0}) {
        for (const double y : {0.0, 1.0}) check_fringes(table, mechanism_at(job, x, y), job.light->settings);
    }
}

}  // namespace

void check_name(const std::string& name, const Table& table, const Where& where) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    if (name.empty() || name.size() > longest_name || name.front() == '.' || name.front() == '-' ||
        name.back() == '.' || !std::all_of(name.begin(), name.end(), allowed)) {
        table.note(where,
                   "the name " + in_quotes(name) + " cannot be the name of a file; give 1 to " +
                       std::to_string(longest_name) +
                       " characters out of A-Z a-z 0-9 _ - . that do not begin with - or . and do not end with .");
    }
}

LutSize read_lut_size(const Table& table) {
    const Value* value = table.find("size");
    if (value == nullptr) return {};
    if (!std::holds_alternative<Value::Array>(value->data))
        return {checked_size(table, "size", *value, allowed_width), std::nullopt};
    const Value::Array& sides = table.checked_array("size", *value);
    if (sides.size() != 2) {
        table.fail(value->where, "size has " + std::to_string(sides.size()) + " numbers; give one, or [width, height]");
    }
    return {checked_size(table, "size", sides[0], allowed_side), checked_size(table, "size", sides[1], allowed_side)};
}

void take_request(const AccuracyRequest& request, PlannedLut& lut) {
    constexpr int placeholder_height = 64;
    lut.request = request;
    lut.job.width = request.width.value_or(lut.job.width);
    if (lut.job.y) lut.job.height = request.height.value_or(placeholder_height);
    lut.format = request.format.value_or(lut.format);
}

AccuracyRequest default_request(const AccuracySettings& accuracy, bool has_y) {
    AccuracyRequest request;
    request.max_de00 = accuracy.max_de00.value_or(AccuracyRequest::default_max_de00);
    request.is_binding = accuracy.max_de00.has_value();
    request.has_bound = request.is_binding || (!accuracy.wavelengths && !accuracy.size.width);
    request.sampling = accuracy.sampling;
    request.may_drop_effects = accuracy.may_drop_effects;
    request.without = accuracy.without;
    request.width = accuracy.size.width;
    if (has_y) request.height = accuracy.size.height;
    return request;
}

std::optional<PlannedLut> read_lut(const Table& table, const Table::Entry& entry, const SceneParts& parts) {
    PlannedLut lut;
    lut.name = lut.entry = entry.key;
    lut.where = entry.key_where;
    lut.job.light = parts.light;
    const SceneMaterial* material = material_of(table, parts.materials);
    if (material != nullptr) {
        lut.job.material = *material;
        read_quantity(table, lut);
        read_axes(table, lut.job);
    } else {
        for (const std::string_view key : {"quantity", "x", "y", "angle_deg", "grating_u", "cos_scatter"})
            table.skip(key);
    }
    read_request(table, parts.accuracy, lut);
    lut.colour = parts.colour;
    read_lut_colour(table, lut.colour);
    read_outputs(table, lut);
    table.expect_all_read();
    if (material == nullptr || !table.is_good()) return {};
    if (parts.light != nullptr && !parts.any_thickness) check_fringes_of_axes(table, lut.job);
    return lut;
}

}  // namespace nacre
