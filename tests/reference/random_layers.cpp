#include "reference/random_layers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace nacre::reference {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every compiler and library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    /// In [0, 1).
    double unit() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
    }
    /// In [low, high], a multiple of 1 / per_unit.
    double between(double low, double high, double per_unit) {
        return std::round((low + unit() * (high - low)) * per_unit) / per_unit;
    }
    int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
    bool chance(double probability) { return unit() < probability; }
    template <std::size_t count>
    const char* one_of(const std::array<const char*, count>& things) {
        return things[static_cast<std::size_t>(unit() * static_cast<double>(count))];
    }

private:
    std::uint64_t state_;
};

constexpr std::array<const char*, 4> glasses{"sio2", "mgf2", "al2o3", "water"};
constexpr std::array<const char*, 4> metals{"ag", "au", "al", "cr"};

ModelIndex named(const char* material) {
    return {material, {}};
}

ModelIndex random_dielectric(Dice& dice) {
    if (dice.chance(0.25)) return named(dice.one_of(glasses));
    return {"", {dice.between(1.3, 2.6, 100.0), 0.0}};
}

ModelIndex random_medium(Dice& dice) {
    if (!dice.chance(0.25)) return random_dielectric(dice);
    if (dice.chance(0.2)) return named("melanin");
    // Even in the logarithm: from a tint to a dye.
    const double k = std::round(1e4 * 1e-3 * std::pow(500.0, dice.unit())) / 1e4;
    return {"", {dice.between(1.3, 2.6, 100.0), k}};
}

ModelIndex random_incident(Dice& dice) {
    if (!dice.chance(0.15)) return {};
    if (dice.chance(0.3)) return named(dice.chance(0.5) ? "sio2" : "al2o3");
    return {"", {dice.between(1.3, 1.9, 100.0), 0.0}};
}

ModelIndex random_substrate(Dice& dice, const ModelIndex& incident) {
    const double kind = dice.unit();
    if (kind < 0.25) return incident;
    return kind < 0.5 ? named(dice.one_of(metals)) : random_medium(dice);
}

void add_layer(LayersModel& model, const ModelIndex& index, double thickness_nm) {
    model.groups.push_back({1, false, {model.layers.size()}});
    model.layers.push_back({index, thickness_nm});
}

void add_film(Dice& dice, LayersModel& model) {
    model.is_film = true;
    // A film as thick as an oil spill; one in five as a cell's wall or a foil.
    const bool is_thick = dice.chance(0.2);
    const double thickness_nm =
        is_thick ? std::round(2000.0 * std::pow(25.0, dice.unit())) : dice.between(50.0, 1200.0, 10.0);
    add_layer(model, random_medium(dice), thickness_nm);
}

void add_random_layers(Dice& dice, LayersModel& model) {
    const int count = dice.chance(0.5) ? dice.whole(1, 8) : dice.whole(9, 40);
    const std::array<ModelIndex, 3> media{random_dielectric(dice), random_medium(dice), random_dielectric(dice)};
    for (int i = 0; i < count; ++i) {
        const bool is_new = count < 9 && dice.chance(0.3);
        const auto known = static_cast<std::size_t>(dice.whole(0, 2));
        add_layer(model, is_new ? random_medium(dice) : media[known], dice.between(20.0, 250.0, 10.0));
    }
}

void add_periods(Dice& dice, LayersModel& model) {
    if (dice.chance(0.3)) add_layer(model, random_dielectric(dice), dice.between(20.0, 300.0, 10.0));
    ModelGroup group{dice.whole(2, 13), true, {}};
    const int members = dice.whole(2, 3);
    for (int i = 0; i < members; ++i) {
        group.layers.push_back(model.layers.size());
        const bool is_air = i > 0 && dice.chance(0.4);
        const ModelIndex index = is_air ? ModelIndex{} : i == 0 ? random_medium(dice) : random_dielectric(dice);
        model.layers.push_back({index, dice.between(40.0, 200.0, 10.0)});
    }
    model.groups.push_back(group);
}

BoundedLayers random_one(int index) {
    constexpr std::array<double, 3> bounds{1.0, 0.1, 0.02};
    Dice dice(0x6c61796572ULL * 1000 + static_cast<std::uint64_t>(index));
    BoundedLayers scene;
    LayersModel& model = scene.model;
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "l%03d", index);
    model.name = name.data();
    model.incident = random_incident(dice);
    model.substrate = random_substrate(dice, model.incident);
    const double kind = dice.unit();
    if (kind < 0.5) {
        add_film(dice, model);
    } else if (kind < 0.75) {
        add_random_layers(dice, model);
    } else {
        add_periods(dice, model);
    }
    if (dice.chance(0.4)) model.illuminant = dice.chance(0.5) ? "A" : "FL11";
    model.observer_deg = dice.chance(0.25) ? 10 : 2;
    constexpr std::array<ModelAxis, 3> axes{ModelAxis::sqrt_cos_theta, ModelAxis::cos_theta, ModelAxis::theta_deg};
    model.x = axes[static_cast<std::size_t>(dice.whole(0, 2))];
    scene.max_de00 = bounds[static_cast<std::size_t>(index % 3)];
    // At the coarsest bound: two axes may take a million texels at another.
    if (index % 12 == 3) {
        const auto layer = static_cast<std::size_t>(dice.whole(0, static_cast<int>(model.layers.size()) - 1));
        model.y_layer = layer;
        model.layers[layer].thickness_nm = dice.between(50.0, 400.0, 10.0);
        model.y_from_nm = model.layers[layer].thickness_nm;
        model.y_to_nm = model.y_from_nm + dice.between(50.0, 300.0, 1.0);
    }
    return scene;
}

// All digits: the program reads the very double that the model holds.
std::string digits(double number) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

std::string index_text(const ModelIndex& index) {
    if (!index.material.empty()) return '"' + index.material + '"';
    const std::string n = digits(index.constant.real());
    return index.constant.imag() == 0.0 ? n : "{ n = " + n + ", k = " + digits(index.constant.imag()) + " }";
}

std::string layer_text(const ModelLayer& layer) {
    return "{ index = " + index_text(layer.index) + ", thickness_nm = " + digits(layer.thickness_nm) + " }";
}

// And the name of the second axis, met on the way.
std::string layers_text(const LayersModel& model, std::string& parameter) {
    std::string text = "layers = [\n";
    for (std::size_t g = 0; g < model.groups.size(); ++g) {
        const ModelGroup& group = model.groups[g];
        const std::string outer = "layers[" + std::to_string(g) + "].";
        text += group.is_written_as_group ? "    { repeat = " + std::to_string(group.repeat) + ", layers = [ " : "    ";
        for (std::size_t i = 0; i < group.layers.size(); ++i) {
            text += layer_text(model.layers[group.layers[i]]) + ", ";
            if (model.y_layer != group.layers[i]) continue;
            parameter = outer + (group.is_written_as_group ? "layers[" + std::to_string(i) + "]." : std::string()) +
                        "thickness_nm";
        }
        text += group.is_written_as_group ? "] },\n" : "\n";
    }
    return text + "]\n";
}

const char* axis_name(ModelAxis axis) {
    if (axis == ModelAxis::sqrt_cos_theta) return "sqrt_cos_theta";
    return axis == ModelAxis::cos_theta ? "cos_theta" : "theta_deg";
}

}  // namespace

std::vector<BoundedLayers> random_layers() {
    std::vector<BoundedLayers> scenes;
    for (int index = 0; index < random_layers_count; ++index) scenes.push_back(random_one(index));
    return scenes;
}

std::string scene_text(const LayersModel& model) {
    std::string parameter = "thickness_nm";
    std::string text = "nacre = 1\n[light]\nilluminant = \"" + model.illuminant + "\"\nobserver = \"" +
                       (model.observer_deg == 10 ? "cie1964_10deg" : "cie1931_2deg") + "\"\n[material." + model.name +
                       "]\nmechanism = \"" + (model.is_film ? "film" : "stack") +
                       "\"\nincident = " + index_text(model.incident) + "\n";
    if (model.is_film) {
        text += "index = " + index_text(model.layers.front().index) +
                "\nthickness_nm = " + digits(model.layers.front().thickness_nm) + "\n";
    } else {
        text += layers_text(model, parameter);
    }
    text += "substrate = " + index_text(model.substrate) + "\n[lut." + model.name + "]\nmaterial = \"" + model.name +
            "\"\nx = \"" + axis_name(model.x) + "\"\n";
    if (model.y_layer) {
        text += "y = { parameter = \"" + parameter + "\", from = " + digits(model.y_from_nm) +
                ", to = " + digits(model.y_to_nm) + " }\n";
    }
    return text;
}

}  // namespace nacre::reference
