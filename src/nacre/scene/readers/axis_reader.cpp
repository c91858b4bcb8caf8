// x and y of a LUT: the angle in one of its forms, or a parameter of the material.
#include "nacre/scene/readers/axis_reader.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
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

// "cos_theta": an axis of the quantity that the mechanism's colour depends on.
Axis read_geometric_axis(const Table& lut, std::string_view key, const Value& value, const Mechanism& mechanism) {
    const std::string& name = lut.checked_text(key, value);
    const Quantity quantity = quantity_of(mechanism);
    const AxisKind* kind = find_kind(name);
    if (kind != nullptr && kind->quantity == quantity) return {kind, {}, 0.0, 1.0};
    const std::string what = kind == nullptr ? "unknown axis " + in_quotes(name)
                                             : "axis " + in_quotes(name) + " has no meaning for mechanism " +
                                                   std::string(mechanism_name(mechanism));
    const std::vector<Parameter> parameters = parameters_of(mechanism);
    const bool is_parameter = std::any_of(parameters.begin(), parameters.end(),
                                          [&](const Parameter& parameter) { return parameter.name == name; });
    lut.fail(value.where, what + "; known: " + comma_separated(kind_names(quantity)) + ", or { parameter = " +
                              in_quotes(is_parameter ? name : "...") + ", from = ..., to = ... }");
}

// The axis over a parameter of that name, or the names of all that there are.
std::variant<Axis, std::vector<std::string>> find_parameter(const Mechanism& mechanism, std::string_view name) {
    std::vector<std::string> known;
    for (Parameter& parameter : parameters_of(mechanism)) {
        if (parameter.name == name) return Axis{nullptr, std::move(parameter), 0.0, 1.0};
        known.push_back(parameter.name);
    }
    return known;
}

std::string no_parameter(const Mechanism& mechanism, std::string_view name, const std::vector<std::string>& known) {
    return "mechanism " + std::string(mechanism_name(mechanism)) + " has no parameter " + in_quotes(name) +
           "; known: " + comma_separated(known);
}

}  // namespace

Axis parameter_axis(const Mechanism& mechanism, std::string_view name, double from, double to) {
    auto found = find_parameter(mechanism, name);
    auto* axis = std::get_if<Axis>(&found);
    if (axis == nullptr) throw Error(no_parameter(mechanism, name, std::get<std::vector<std::string>>(found)));
    axis->from = from;
    axis->to = to;
    return std::move(*axis);
}

Axis read_axis(const Table& lut, std::string_view key, const Value& value, const Mechanism& mechanism) {
    if (std::holds_alternative<std::string>(value.data)) return read_geometric_axis(lut, key, value, mechanism);
    const Table& table = lut.checked_table(key, value);
    const std::string name = table.text("parameter");
    auto found = find_parameter(mechanism, name);
    if (const auto* known = std::get_if<std::vector<std::string>>(&found))
        table.fail_at("parameter", no_parameter(mechanism, name, *known));
    Axis axis = std::get<Axis>(std::move(found));
    axis.from = table.number("from", axis.parameter.allowed);
    axis.to = table.number("to", axis.parameter.allowed);
    table.expect_all_read();
    if (!table.is_good()) return axis;
    if (axis.from == axis.to) {
        table.fail_at("to", "from and to are both " + number_text(axis.to) + "; an axis needs two different ends");
    }
    check_axis(axis, mechanism, table, value.where);
    return axis;
}

std::string axis_toml(const Axis& axis) {
    if (axis.is_angle()) return toml_string(axis.kind->name);
    return "{ parameter = " + toml_string(axis.parameter.name) + ", from = " + number_text(axis.from) +
           ", to = " + number_text(axis.to) + " }";
}

}  // namespace nacre
