#include "nacre/scene/readers/axis_reader.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {
namespace {

const AxisKind* find_kind(std::string_view name) {
    const auto kinds = axis_kinds();
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const AxisKind& kind) { return kind.name == name; });
    return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> kind_names(Quantity quantity) {
    std::vector<std::string> names;
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.quantity == quantity) names.emplace_back(kind.name);
    }
    return names;
}

// A palette whose picks differ must not pass through a state in which two of them share an angle.
void check_angles_stay_apart(const Axis& axis, const Table& table, const Where& where, const Mechanism& mechanism) {
    const auto* palette = std::get_if<Palette>(&mechanism);
    if (palette == nullptr || !axis.parameter.name.ends_with("].angle_deg")) return;
    const auto [low, high] = std::minmax(axis.from, axis.to);
    for (std::size_t i = 0; i < palette->picks.size(); ++i) {
        if ("picks[" + std::to_string(i) + "].angle_deg" == axis.parameter.name) continue;
        const double angle_deg = palette->picks[i].angle_deg;
        if (angle_deg > low - smallest_pick_distance_deg && angle_deg < high + smallest_pick_distance_deg) {
            table.fail(where, axis.parameter.name + " from " + number_text(axis.from) + " to " + number_text(axis.to) +
                                  " passes picks[" + std::to_string(i) + "] at " + number_text(angle_deg) +
                                  " degrees; two picks at one angle have no colour between them");
        }
    }
}

}  // namespace

Axis parameter_axis(const Mechanism& mechanism, std::string_view name, double from, double to) {
    std::vector<std::string> known;
    for (Parameter& parameter : parameters_of(mechanism)) {
        if (parameter.name == name) return {nullptr, std::move(parameter), from, to};
        known.push_back(parameter.name);
    }
    throw Error("mechanism " + std::string(mechanism_name(mechanism)) + " has no parameter " + in_quotes(name) +
                "; known: " + comma_separated(known));
}

Axis read_axis(const Table& lut, std::string_view key, const Value& value, const Mechanism& mechanism) {
    if (std::holds_alternative<std::string>(value.data)) {
        const std::string& name = lut.checked_text(key, value);
        Axis axis;
        axis.kind = find_kind(name);
        const Quantity quantity = quantity_of(mechanism);
        if (axis.kind == nullptr || axis.kind->quantity != quantity) {
            const std::string what = axis.kind == nullptr
                                         ? "unknown axis " + in_quotes(name)
                                         : "axis " + in_quotes(name) + " means nothing for mechanism " +
                                               std::string(mechanism_name(mechanism));
            lut.fail(value.where, what + "; known: " + comma_separated(kind_names(quantity)) +
                                      ", or { parameter = \"...\", from = ..., to = ... }");
        }
        return axis;
    }
    const Table& table = lut.checked_table(key, value);
    const std::string name = table.text("parameter");
    Axis axis;
    try {
        axis = parameter_axis(mechanism, name, 0.0, 1.0);
    } catch (const Error& error) {
        table.fail_at("parameter", error.what());
    }
    axis.from = table.number("from", axis.parameter.allowed);
    axis.to = table.number("to", axis.parameter.allowed);
    table.expect_all_read();
    if (axis.from == axis.to) {
        table.fail_at("to", "from and to are both " + number_text(axis.to) + "; an axis needs two different ends");
    }
    check_angles_stay_apart(axis, table, value.where, mechanism);
    return axis;
}

std::string axis_toml(const Axis& axis) {
    if (axis.is_angle()) return toml_string(axis.kind->name);
    return "{ parameter = " + toml_string(axis.parameter.name) + ", from = " + number_text(axis.from) +
           ", to = " + number_text(axis.to) + " }";
}

}  // namespace nacre
