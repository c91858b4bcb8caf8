#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_repeat{1, 100000};
constexpr Allowed allowed_films{1, 50000};
constexpr double most_layers = 100000;
constexpr double most_irregular_layers = 1000;
constexpr std::size_t deepest_group = 16;
constexpr std::size_t most_layer_parameters = 200;

// Where lamellae are looked for.
constexpr FreeRange usual_gap{1.0, 2.6};
constexpr FreeRange usual_lamella{20.0, 400.0};
constexpr FreeRange usual_films{1.0, 40.0, FreeScale::whole};

double largest_k(const IndexCurve& curve, double first_nm, double last_nm) {
    double largest = 0.0;
    for (double nm = first_nm; nm <= last_nm; nm += 1.0) largest = std::max(largest, curve.at(nm).imag());
    return largest;
}

class StackReader {
public:
    explicit StackReader(const IndexReader& index) : index_(index) {}

    std::vector<Layer> read(const Table& table, const Value& value, bool is_in_group) {
        const Value::Array& list = table.checked_array("layers", value);
        if (list.empty()) table.fail(value.where, "layers is empty; give one layer or more");
        if (depth_ > deepest_group) {
            table.fail(value.where, "groups are nested deeper than " + std::to_string(deepest_group));
        }
        ++depth_;
        std::vector<Layer> layers;
        for (const Value& element : list) {
            const Table& item = table.checked_table("layers", element);
            layers.push_back(item.find("layers") != nullptr || item.find("repeat") != nullptr
                                 ? read_group(item)
                                 : read_layer(item, is_in_group));
            item.expect_all_read();
        }
        --depth_;
        return layers;
    }

private:
    Layer read_group(const Table& table) {
        Layer group;
        group.repeat = table.integer_or("repeat", allowed_repeat, 1);
        const Value* layers = table.find("layers");
        if (layers == nullptr) table.fail_missing("layers", "a group with repeat needs what is to be repeated");
        group.layers = read(table, *layers, true);
        return group;
    }

    Layer read_layer(const Table& table, bool is_in_group) {
        Layer layer;
        read_layer_index(table, is_in_group, layer);
        read_layer_thickness(table, is_in_group, layer);
        if (const Value* value = table.find("incoherent")) {
            const auto* flag = std::get_if<bool>(&value->data);
            if (flag == nullptr) table.fail(value->where, "incoherent = " + value->text() + "; give true or false");
            layer.is_incoherent = *flag;
            if (layer.is_incoherent && is_in_group) {
                table.fail(value->where,
                           "a layer of a group cannot be incoherent; write the layers out, or mark one outside");
            }
            if (layer.is_incoherent && (layer.last_index || layer.last_thickness_nm))
                table.fail(value->where, "an incoherent layer cannot be graded");
        }
        return layer;
    }

    void read_layer_index(const Table& table, bool is_in_group, Layer& layer) const {
        const Value* value = table.find("index");
        if (value == nullptr) table.fail_missing("index", "give a number, { n, k }, or the name of a material");
        const Table* range = range_of(table, "index", *value);
        if (range == nullptr) {
            layer.index = index_.read(table, "index", *value);
            return;
        }
        check_may_grade(table, *value, is_in_group);
        layer.index = read_required_index(*range, "from", index_);
        layer.last_index = read_required_index(*range, "to", index_);
        range->expect_all_read();
    }

    static void read_layer_thickness(const Table& table, bool is_in_group, Layer& layer) {
        const Value* value = table.find("thickness_nm");
        if (value == nullptr) table.fail_missing("thickness_nm", "it has no default");
        const Table* range = range_of(table, "thickness_nm", *value);
        if (range == nullptr) {
            layer.thickness_nm = table.checked_number("thickness_nm", *value, allowed_thickness);
            return;
        }
        check_may_grade(table, *value, is_in_group);
        layer.thickness_nm = range->number("from", allowed_thickness);
        layer.last_thickness_nm = range->number("to", allowed_thickness);
        range->expect_all_read();
    }

    static void check_may_grade(const Table& table, const Value& value, bool is_in_group) {
        if (!is_in_group)
            table.fail(value.where, "from and to run over the repeats of a group, and this layer is in none");
    }

    const IndexReader& index_;
    std::size_t depth_ = 0;
};

// Sun's biological multilayer: films of one index with air between them.
std::vector<Layer> read_lamellae(const Table& table, const IndexReader& reader) {
    // So that one that is missing is not taken for the misspelling of another.
    for (const std::string_view known : {"film", "film_nm", "gap", "gap_nm", "films"}) table.find(known);
    Layer film;
    film.index = read_required_index(table, "film", reader);
    film.thickness_nm = table.number("film_nm", allowed_thickness);
    Layer gap;
    gap.index = reader.read_or(table, "gap", Index(1.0));
    gap.thickness_nm = table.number("gap_nm", allowed_thickness);
    Layer group;
    group.repeat = table.integer_or("films", allowed_films, 10);
    group.layers = {film, gap};
    return {group};
}

// TOML of layers, indented by depth.
std::string layers_toml(const std::vector<Layer>& layers, const std::string& indent) {
    std::string text = "[\n";
    for (const Layer& layer : layers) {
        text += indent + "    { ";
        if (layer.repeat > 0) {
            text +=
                "repeat = " + std::to_string(layer.repeat) + ", layers = " + layers_toml(layer.layers, indent + "    ");
        } else {
            const std::string index = index_toml(layer.index);
            text += "index = " +
                    (layer.last_index ? "{ from = " + index + ", to = " + index_toml(*layer.last_index) + " }" : index);
            const std::string thickness = number_text(layer.thickness_nm);
            text += ", thickness_nm = " +
                    (layer.last_thickness_nm
                         ? "{ from = " + thickness + ", to = " + number_text(*layer.last_thickness_nm) + " }"
                         : thickness);
            if (layer.is_incoherent) text += ", incoherent = true";
        }
        text += " },\n";
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

void add_layer_parameters(const std::vector<Layer>& layers, const std::string& prefix, const LayerPath& outer,
                          std::vector<Parameter>& parameters) {
    for (std::size_t i = 0; i < layers.size() && parameters.size() < most_layer_parameters; ++i) {
        const std::string name = prefix + "layers[" + std::to_string(i) + "].";
        LayerPath path = outer;
        path.push_back(i);
        const Layer& layer = layers[i];
        if (layer.repeat > 0) {
            add_layer_parameters(layer.layers, name, path, parameters);
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

Index read_incident(const Table& table, const IndexReader& reader) {
    Index incident = reader.read_or(table, "incident", Index(1.0));
    // Glass has a k of 1e-8, which nobody sees at this side of the layers.
    constexpr double transparent = 1e-6;
    if (incident.is_constant() && incident.constant.imag() == 0.0) return incident;
    if (!incident.is_constant() && largest_k(*incident.curve, reader.first_nm, reader.last_nm) <= transparent) {
        IndexCurve lossless = *incident.curve;
        lossless.k = 0.0;
        return Index(std::make_shared<const IndexCurve>(std::move(lossless)));
    }
    table.fail_at("incident",
                  "incident absorbs, so no light comes from far away in it; allowed is a medium with k = 0");
}

double read_spread(const Table& table) {
    return table.number_or("thickness_spread_nm", allowed_spread, 0.0);
}

Index read_required_index(const Table& table, std::string_view key, const IndexReader& reader) {
    const Value* value = table.find(key);
    if (value == nullptr) table.fail_missing(key, "give a number, { n, k }, or the name of a material");
    return reader.read(table, key, *value);
}

void add_index_parameters(const std::string& prefix, const std::string& of_what, const Index& index,
                          const std::function<Index&(Mechanism&)>& find, std::vector<Parameter>& parameters) {
    if (!index.is_constant()) return;
    parameters.push_back({prefix + "n", "refractive index" + of_what, allowed_n,
                          [find](Mechanism& m, double value) { find(m).constant.real(value); }});
    parameters.push_back({prefix + "k", "absorption index" + of_what, allowed_k,
                          [find](Mechanism& m, double value) { find(m).constant.imag(value); }});
}

Stack read_stack(const Table& table, const IndexReader& index) {
    Stack stack;
    stack.incident = read_incident(table, index);
    const std::string form = table.text_or("form", "layers");
    if (form == "lamellae") {
        stack.layers = read_lamellae(table, index);
    } else if (form == "layers") {
        const Value* layers = table.find("layers");
        if (layers == nullptr) {
            table.fail_missing("layers",
                               "give [ { index, thickness_nm }, ... ] in the order in which light meets them");
        }
        stack.layers = StackReader(index).read(table, *layers, false);
    } else {
        table.fail_at("form", "unknown form " + in_quotes(form) + "; known: layers, lamellae");
    }
    stack.substrate = index.read_or(table, "substrate", stack.incident);
    stack.thickness_spread_nm = read_spread(table);
    const double layers = expanded_layers(stack.layers);
    const double most = stack.thickness_spread_nm > 0.0 ? most_irregular_layers : most_layers;
    if (layers > most) {
        table.fail_at(form == "lamellae" ? "films" : "layers",
                      "the stack has " + limit_text(layers) + " layers, repeats counted; allowed " + limit_text(most) +
                          (most == most_layers ? "" : " with thickness_spread_nm"));
    }
    return stack;
}

namespace {

Layer& lamella(Mechanism& mechanism, std::size_t which) {
    return std::get<Stack>(mechanism).layers.front().layers[which];
}

}  // namespace

MechanismSearch stack_search(const Table& table, const IndexReader& index) {
    MechanismSearch search;
    if (table.find("layers") != nullptr) {
        search.start = read_stack(table, index);
        return search;
    }
    if (table.text_or("form", "lamellae") != "lamellae") {
        table.fail_at("form",
                      "picks lead to lamellae, two materials that take turns; give form = \"lamellae\", or "
                      "the layers themselves");
    }
    Stack stack;
    stack.incident = read_incident(table, index);
    stack.layers.resize(1);
    stack.layers.front().repeat = 1;
    stack.layers.front().layers.resize(2);
    stack.thickness_spread_nm = read_spread(table);
    search.start = stack;
    FreeReader reader(table, index, search);
    reader.index("film", usual_index, [](Mechanism& m, const Index& value) { lamella(m, 0).index = value; });
    reader.number("film_nm", allowed_thickness, usual_lamella,
                  [](Mechanism& m, double value) { lamella(m, 0).thickness_nm = value; });
    reader.index("gap", usual_gap, [](Mechanism& m, const Index& value) { lamella(m, 1).index = value; });
    reader.number("gap_nm", allowed_thickness, usual_lamella,
                  [](Mechanism& m, double value) { lamella(m, 1).thickness_nm = value; });
    reader.exchange({{"film", "gap"}, {"film_nm", "gap_nm"}});
    const Allowed allowed = stack.thickness_spread_nm > 0.0 ? Allowed{1, most_irregular_layers / 2} : allowed_films;
    reader.whole_number("films", allowed, usual_films,
                        [](Mechanism& m, int value) { std::get<Stack>(m).layers.front().repeat = value; });
    reader.index("substrate", usual_substrate,
                 [](Mechanism& m, const Index& value) { std::get<Stack>(m).substrate = value; });
    return search;
}

std::vector<Parameter> stack_parameters(const Stack& stack) {
    std::vector<Parameter> parameters;
    if (expanded_layers(stack.layers) <= most_irregular_layers) {
        parameters.push_back({"thickness_spread_nm", "spread of the thicknesses", allowed_spread,
                              [](Mechanism& m, double value) { std::get<Stack>(m).thickness_spread_nm = value; }});
    }
    add_index_parameters(
        "substrate.", " of the substrate", stack.substrate,
        [](Mechanism& m) -> Index& { return std::get<Stack>(m).substrate; }, parameters);
    add_layer_parameters(stack.layers, "", {}, parameters);
    return parameters;
}

std::string stack_toml(const Stack& stack) {
    std::string text = "mechanism = \"stack\"\nincident = " + index_toml(stack.incident) +
                       "\nlayers = " + layers_toml(stack.layers, "") + "\nsubstrate = " + index_toml(stack.substrate) +
                       "\n";
    if (stack.thickness_spread_nm > 0.0)
        text += "thickness_spread_nm = " + number_text(stack.thickness_spread_nm) + "\n";
    return text;
}

}  // namespace nacre
