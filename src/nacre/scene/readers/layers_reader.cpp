// The layers of a stack, which may be grouped, repeated and graded.
#include "nacre/scene/readers/layers_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <type_traits>
#include <variant>

#include "nacre/base/text.h"
#include "nacre/scene/readers/index_keys.h"

namespace nacre {
namespace {

constexpr Allowed allowed_repeat{1, 100000};
constexpr std::size_t deepest_group = 16;           // chosen: reading groups recurses
constexpr std::size_t most_layer_parameters = 200;  // chosen: messages list them all

// A layer of a stack by the way to it: indices from the outermost group inwards.
using LayerPath = std::vector<std::size_t>;

Layer& layer_at(Mechanism& mechanism, const LayerPath& path) {
    std::vector<Layer>* layers = &std::get<Stack>(mechanism).layers;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) layers = &(*layers)[path[i]].layers;
    return (*layers)[path.back()];
}

// "layers[0].layers[1]."
std::string prefix_of(const LayerPath& path) {
    std::string prefix;
    for (const std::size_t i : path) prefix += "layers[" + std::to_string(i) + "].";
    return prefix;
}

LayerPath path_to(LayerPath outer, std::size_t i) {
    outer.push_back(i);
    return outer;
}

bool is_in_group(const LayerPath& path) {
    return path.size() > 1;
}

// A key of a layer that may be graded, and what it is of a layer.
template <typename Number>
struct LayerKey {
    std::string_view key;
    Number Layer::*first;
    std::optional<Number> Layer::*last;
    Allowed allowed;  // of a number that is searched for
};
constexpr LayerKey<double> thickness_key{"thickness_nm", &Layer::thickness_nm, &Layer::last_thickness_nm,
                                         allowed_thickness};
constexpr LayerKey<Index> index_key{"index", &Layer::index, &Layer::last_index, allowed_n};

// Where a thickness is looked for that the scene does not bound: up to where hardly any light gets through a metal, or
// up to some orders of interference.
FreeRange usual_layer(const Index& index, const IndexReader& reader) {
    constexpr double thickest_nm = 1000.0;
    constexpr double deepest = 7.0;  // chosen: exp(-7) is 0.1 % of the light
    const double wavelength_nm = 0.5 * (reader.first_nm + reader.last_nm);
    const double per_nm = 4.0 * std::numbers::pi * index.at(wavelength_nm).imag() / wavelength_nm;
    return {0.0, std::min(thickest_nm, deepest / std::max(per_nm, 1e-9))};
}

class LayersReader {
public:
    LayersReader(const IndexReader& index, FreeReader* free) : index_(index), free_(free) {}

    std::vector<Layer> read_list(const Table& table, const Value& value, const LayerPath& outer) const {
        const Value::Array& list = table.checked_array("layers", value);
        // A stack without layers is a bare surface, with which a coating is compared.
        if (list.empty() && !outer.empty()) table.fail(value.where, "layers is empty; give one layer or more");
        if (outer.size() > deepest_group) {
            table.fail(value.where, "groups are nested too deeply; at most " + std::to_string(deepest_group) +
                                        " levels are allowed");
        }
        std::vector<Layer> layers;
        for (std::size_t i = 0; i < list.size(); ++i) {
            attempt(table, list[i].where, [&] {
                const Table& item = table.checked_table("layers", list[i]);
                const bool is_group = item.find("layers") != nullptr || item.find("repeat") != nullptr;
                const LayerPath path = path_to(outer, i);
                layers.push_back(is_group ? read_group(item, path) : read_layer(item, path));
                item.expect_all_read();
            });
        }
        return layers;
    }

private:
    Layer read_group(const Table& table, const LayerPath& path) const {
        Layer group;
        group.repeat = read_repeat(table, path);
        const Value* layers = table.find("layers");
        if (layers == nullptr) table.fail_missing("layers", "a group with repeat needs layers to repeat");
        group.layers = read_list(table, *layers, path);
        return group;
    }

    // A free one is the largest for now, so that all limits on repeats hold for it.
    int read_repeat(const Table& table, const LayerPath& path) const {
        const Value* value = table.find("repeat");
        const Table* range = value == nullptr ? nullptr : range_of(table, "repeat", *value);
        if (range == nullptr) return table.integer_or("repeat", allowed_repeat, 1);
        if (free_ == nullptr) {
            refuse_range(table, "repeat", *value);
            return 1;
        }
        const FreeRange bounds = free_->bounds("repeat", *range, allowed_repeat, FreeScale::whole);
        free_->leave_free(prefix_of(path) + "repeat", bounds, [path](Mechanism& m, double repeat) {
            layer_at(m, path).repeat = static_cast<int>(std::lround(repeat));
        });
        return static_cast<int>(std::lround(bounds.high));
    }

    Layer read_layer(const Table& table, const LayerPath& path) const {
        Layer layer;
        read_number(table, index_key, path, layer);
        if (table.find("thickness_nm") == nullptr && free_ != nullptr) {
            layer.thickness_nm = leave_free(thickness_key, thickness_key.first, prefix_of(path) + "thickness_nm", path,
                                            usual_layer(layer.index, index_));
        } else {
            read_number(table, thickness_key, path, layer);
        }
        read_incoherent(table, path, layer);
        return layer;
    }

    // A value, a free one, or a graded one, whose ends may be free.
    template <typename Number>
    void read_number(const Table& table, const LayerKey<Number>& key, const LayerPath& path, Layer& layer) const {
        const Value* value = table.find(key.key);
        const Table* range = value == nullptr ? nullptr : range_of(table, key.key, *value);
        const std::string name = prefix_of(path) + std::string(key.key);
        if (range == nullptr || is_free(*range, path)) {
            layer.*key.first = read_end(table, key.key, key, key.first, name, path);
            return;
        }
        if (free_ == nullptr && range->find("free") != nullptr) {
            refuse_range(table, key.key, *value);
            return;
        }
        if (!is_in_group(path)) {
            table.note(value->where,
                       "from and to run over the repeats of a group, and this layer is not in a group; give one "
                       "value, or picks that a search for it is to meet");
        }
        layer.*key.first = read_end(*range, "from", key, key.first, name + ".from", path);
        layer.*key.last = read_end(*range, "to", key, key.last, name + ".to", path);
        range->expect_all_read();
    }

    // Whether { from, to } are the bounds of a search.
    bool is_free(const Table& range, const LayerPath& path) const {
        if (free_ == nullptr) return false;
        const Value* flag = range.find("free");
        if (flag == nullptr) return !is_in_group(path);
        const auto* given = std::get_if<bool>(&flag->data);
        if (given == nullptr) range.fail(flag->where, "free = " + flag->text() + "; give true or false");
        return *given;
    }

    template <typename Number, typename Member>
    Number read_end(const Table& table, std::string_view at, const LayerKey<Number>& key, Member member,
                    const std::string& name, const LayerPath& path) const {
        const Value* value = table.find(at);
        const Table* range = value == nullptr ? nullptr : range_of(table, at, *value);
        if (range != nullptr && free_ != nullptr) {
            const FreeRange bounds = free_->bounds(name, *range, key.allowed, FreeScale::even);
            return leave_free(key, member, name, path, bounds);
        }
        if constexpr (std::is_same_v<Number, Index>) {
            return read_required_index(table, at, index_);
        } else {
            return read_thickness(table, at);
        }
    }

    template <typename Number, typename Member>
    Number leave_free(const LayerKey<Number>&, Member member, const std::string& name, const LayerPath& path,
                      const FreeRange& bounds) const {
        FreeNumber& number = free_->leave_free(
            name, bounds, [path, member](Mechanism& m, double value) { layer_at(m, path).*member = Number(value); });
        number.is_thickness = std::is_same_v<Number, double>;
        if constexpr (std::is_same_v<Number, Index>)
            number.set_index = [path, member](Mechanism& m, const Index& value) { layer_at(m, path).*member = value; };
        return Number(number.at(0.5));
    }

    static void read_incoherent(const Table& table, const LayerPath& path, Layer& layer) {
        const Value* value = table.find("incoherent");
        if (value == nullptr) return;
        const auto* flag = std::get_if<bool>(&value->data);
        if (flag == nullptr) {
            table.note(value->where, "incoherent = " + value->text() + "; give true or false");
            return;
        }
        layer.is_incoherent = *flag;
        if (layer.is_incoherent && is_in_group(path)) {
            table.note(value->where,
                       "a layer of a group cannot be incoherent; write the layers out, or mark one outside");
        }
        if (layer.is_incoherent && (layer.last_index || layer.last_thickness_nm))
            table.note(value->where, "an incoherent layer cannot be graded; give one index and one thickness_nm");
    }

    const IndexReader& index_;
    FreeReader* free_;
};

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

void add_parameters(const std::vector<Layer>& layers, const LayerPath& outer, std::vector<Parameter>& parameters) {
    for (std::size_t i = 0; i < layers.size() && parameters.size() < most_layer_parameters; ++i) {
        const LayerPath path = path_to(outer, i);
        const std::string name = prefix_of(path);
        const Layer& layer = layers[i];
        if (layer.repeat > 0) {
            add_parameters(layer.layers, path, parameters);
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

std::vector<Layer> read_layers(const Table& table, const Value& value, const IndexReader& index, FreeReader* free) {
    return LayersReader(index, free).read_list(table, value, {});
}

std::string layers_toml(const std::vector<Layer>& layers) {
    return layers_toml(layers, "");
}

void add_layer_parameters(const std::vector<Layer>& layers, std::vector<Parameter>& parameters) {
    add_parameters(layers, {}, parameters);
}

}  // namespace nacre
