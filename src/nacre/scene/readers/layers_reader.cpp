// The layers of a stack, which may be grouped, repeated and graded.
#include "nacre/scene/readers/layers_reader.h"

#include <cstddef>
#include <memory>
#include <variant>

#include "nacre/base/text.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/index_keys.h"

namespace nacre {
namespace {

constexpr Allowed allowed_repeat{1, 100000};
constexpr std::size_t deepest_group = 16;           // chosen: reading groups recurses
constexpr std::size_t most_layer_parameters = 200;  // chosen: messages list them all

// How many groups a layer is in.
using Depth = std::size_t;

void check_may_grade(const Table& table, const Value& value, Depth depth) {
    if (depth > 0) return;
    table.note(value.where,
               "from and to run over the repeats of a group, and this layer is not in a group; give one "
               "value");
}

void read_layer_index(const Table& table, Depth depth, const IndexReader& reader, Layer& layer) {
    const Value* value = table.find("index");
    const Table* range = value == nullptr ? nullptr : range_of(table, "index", *value);
    if (range == nullptr) {
        layer.index = read_required_index(table, "index", reader);
        return;
    }
    check_may_grade(table, *value, depth);
    layer.index = read_required_index(*range, "from", reader);
    layer.last_index = read_required_index(*range, "to", reader);
    range->expect_all_read();
}

void read_layer_thickness(const Table& table, Depth depth, Layer& layer) {
    const Value* value = table.find("thickness_nm");
    const Table* range = value == nullptr ? nullptr : range_of(table, "thickness_nm", *value);
    if (range == nullptr) {
        layer.thickness_nm = read_thickness(table, "thickness_nm");
        return;
    }
    check_may_grade(table, *value, depth);
    layer.thickness_nm = read_thickness(*range, "from");
    layer.last_thickness_nm = read_thickness(*range, "to");
    range->expect_all_read();
}

void read_incoherent(const Table& table, Depth depth, Layer& layer) {
    const Value* value = table.find("incoherent");
    if (value == nullptr) return;
    const auto* flag = std::get_if<bool>(&value->data);
    if (flag == nullptr) {
        table.note(value->where, "incoherent = " + value->text() + "; give true or false");
        return;
    }
    layer.is_incoherent = *flag;
    if (layer.is_incoherent && depth > 0) {
        table.note(value->where, "a layer of a group cannot be incoherent; write the layers out, or mark one outside");
    }
    if (layer.is_incoherent && (layer.last_index || layer.last_thickness_nm))
        table.note(value->where, "an incoherent layer cannot be graded; give one index and one thickness_nm");
}

std::vector<Layer> read_list(const Table& table, const Value& value, Depth depth, const IndexReader& reader);

Layer read_group(const Table& table, Depth depth, const IndexReader& reader) {
    Layer group;
    group.repeat = table.integer_or("repeat", allowed_repeat, 1);
    const Value* layers = table.find("layers");
    if (layers == nullptr) table.fail_missing("layers", "a group with repeat needs layers to repeat");
    group.layers = read_list(table, *layers, depth + 1, reader);
    return group;
}

Layer read_layer(const Table& table, Depth depth, const IndexReader& reader) {
    Layer layer;
    read_layer_index(table, depth, reader, layer);
    read_layer_thickness(table, depth, layer);
    read_incoherent(table, depth, layer);
    return layer;
}

std::vector<Layer> read_list(const Table& table, const Value& value, Depth depth, const IndexReader& reader) {
    const Value::Array& list = table.checked_array("layers", value);
    // A stack without layers is a bare surface, with which a coating is compared.
    if (list.empty() && depth > 0) table.fail(value.where, "layers is empty; give one layer or more");
    if (depth > deepest_group) {
        table.fail(value.where,
                   "groups are nested too deeply; at most " + std::to_string(deepest_group) + " levels are allowed");
    }
    std::vector<Layer> layers;
    for (const Value& element : list) {
        attempt(table, element.where, [&] {
            const Table& item = table.checked_table("layers", element);
            const bool is_group = item.find("layers") != nullptr || item.find("repeat") != nullptr;
            layers.push_back(is_group ? read_group(item, depth, reader) : read_layer(item, depth, reader));
            item.expect_all_read();
        });
    }
    return layers;
}

// TOML of layers, indented by depth.
std::string from_to(const std::string& from, const std::string& to) {
    return "{ from = " + from + ", to = " + to + " }";
}

std::string layer_toml(const Layer& layer) {
    const std::string index = index_toml(layer.index);
    const std::string thickness = number_text(layer.thickness_nm);
    return "index = " + (layer.last_index ? from_to(index, index_toml(*layer.last_index)) : index) +
           ", thickness_nm = " +
           (layer.last_thickness_nm ? from_to(thickness, number_text(*layer.last_thickness_nm)) : thickness) +
           (layer.is_incoherent ? ", incoherent = true" : "");
}

std::string layers_toml(const std::vector<Layer>& layers, const std::string& indent) {
    std::string text = "[\n";
    for (const Layer& layer : layers) {
        const std::string content = layer.repeat > 0 ? "repeat = " + std::to_string(layer.repeat) +
                                                           ", layers = " + layers_toml(layer.layers, indent + "    ")
                                                     : layer_toml(layer);
        text += indent + "    { " + content + " },\n";
    }
    return text + indent + "]";
}

// A layer of a stack by the way to it: indices from the outermost group inwards.
using LayerPath = std::vector<std::size_t>;

Layer& layer_at(Mechanism& mechanism, const LayerPath& path) {
    std::vector<Layer>* layers = &std::get<Stack>(mechanism).layers;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) layers = &(*layers)[path[i]].layers;
    return (*layers)[path.back()];
}

void add_parameters(const std::vector<Layer>& layers, const std::string& prefix, const LayerPath& outer,
                    std::vector<Parameter>& parameters) {
    for (std::size_t i = 0; i < layers.size() && parameters.size() < most_layer_parameters; ++i) {
        const std::string name = prefix + "layers[" + std::to_string(i) + "].";
        LayerPath path = outer;
        path.push_back(i);
        const Layer& layer = layers[i];
        if (layer.repeat > 0) {
            add_parameters(layer.layers, name, path, parameters);
            continue;
        }
        const std::string of_layer = " of " + name.substr(0, name.size() - 1);
        if (!layer.last_thickness_nm) {
            parameters.push_back({name + "thickness_nm", "thickness" + of_layer, allowed_thickness,
                                  [path](Mechanism& m, double value) { layer_at(m, path).thickness_nm = value; }});
        }
        if (!layer.last_index) {
            add_index_parameters(
                name, of_layer, layer.index, [path](Mechanism& m) -> Index& { return layer_at(m, path).index; },
                parameters);
        }
    }
}

}  // namespace

std::vector<Layer> read_layers(const Table& table, const Value& value, const IndexReader& index) {
    return read_list(table, value, 0, index);
}

std::string layers_toml(const std::vector<Layer>& layers) {
    return layers_toml(layers, "");
}

void add_layer_parameters(const std::vector<Layer>& layers, std::vector<Parameter>& parameters) {
    add_parameters(layers, "", {}, parameters);
}

}  // namespace nacre
