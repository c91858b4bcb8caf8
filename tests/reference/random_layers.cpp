#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "reference/dice.h"
#include "reference/materials.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

constexpr std::array<const char*, 4> glasses{"sio2", "mgf2", "al2o3", "water"};
constexpr std::array<const char*, 4> metals{"ag", "au", "al", "cr"};

Index random_dielectric(Dice& dice) {
    if (dice.chance(0.25)) return named_index(dice.one_of(glasses));
    return dice.between(1.3, 2.6, 100.0);
}

Index random_medium(Dice& dice) {
    if (!dice.chance(0.25)) return random_dielectric(dice);
    if (dice.chance(0.2)) return named_index("melanin");
    // Even in the logarithm: from a tint to a dye.
    const double k = std::round(1e4 * 1e-3 * std::pow(500.0, dice.unit())) / 1e4;
    return RefractiveIndex(dice.between(1.3, 2.6, 100.0), k);
}

Index random_incident(Dice& dice) {
    if (!dice.chance(0.15)) return 1.0;
    if (dice.chance(0.3)) return named_index(dice.chance(0.5) ? "sio2" : "al2o3");
    return dice.between(1.3, 1.9, 100.0);
}

Index random_substrate(Dice& dice, const Index& incident) {
    const double kind = dice.unit();
    if (kind < 0.25) return incident;
    return kind < 0.5 ? named_index(dice.one_of(metals)) : random_medium(dice);
}

Layer layer_of(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

// Thicknesses are thrown before indices where both stand in one line.
Film random_film(Dice& dice) {
    Film film;
    // A film as thick as an oil spill; one in five as a cell's wall or a foil.
    const bool is_thick = dice.chance(0.2);
    film.thickness_nm = is_thick ? std::round(2000.0 * std::pow(25.0, dice.unit())) : dice.between(50.0, 1200.0, 10.0);
    film.index = random_medium(dice);
    return film;
}

std::vector<Layer> some_layers(Dice& dice) {
    const int count = dice.chance(0.5) ? dice.whole(1, 8) : dice.whole(9, 40);
    const std::array<Index, 3> media{random_dielectric(dice), random_medium(dice), random_dielectric(dice)};
    std::vector<Layer> layers;
    for (int i = 0; i < count; ++i) {
        const bool is_new = count < 9 && dice.chance(0.3);
        const auto known = static_cast<std::size_t>(dice.whole(0, 2));
        const double thickness_nm = dice.between(20.0, 250.0, 10.0);
        layers.push_back(layer_of(is_new ? random_medium(dice) : media[known], thickness_nm));
    }
    return layers;
}

std::vector<Layer> some_periods(Dice& dice) {
    std::vector<Layer> layers;
    if (dice.chance(0.3)) {
        const double thickness_nm = dice.between(20.0, 300.0, 10.0);
        layers.push_back(layer_of(random_dielectric(dice), thickness_nm));
    }
    Layer group;
    group.repeat = dice.whole(2, 13);
    const int members = dice.whole(2, 3);
    for (int i = 0; i < members; ++i) {
        const bool is_air = i > 0 && dice.chance(0.4);
        const Index index = is_air ? Index(1.0) : i == 0 ? random_medium(dice) : random_dielectric(dice);
        group.layers.push_back(layer_of(index, dice.between(40.0, 200.0, 10.0)));
    }
    layers.push_back(group);
    return layers;
}

// A thickness becomes the second axis.
void add_second_axis(Dice& dice, ModelScene& scene) {
    std::vector<std::pair<std::string, double*>> thicknesses;
    if (auto* film = std::get_if<Film>(&scene.mechanism)) thicknesses = {{"", &film->thickness_nm}};
    if (auto* stack = std::get_if<Stack>(&scene.mechanism)) {
        for (std::size_t i = 0; i < stack->layers.size(); ++i) {
            Layer& layer = stack->layers[i];
            const std::string outer = "layers[" + std::to_string(i) + "].";
            if (layer.repeat == 0) thicknesses.emplace_back(outer, &layer.thickness_nm);
            for (std::size_t j = 0; j < layer.layers.size(); ++j)
                thicknesses.emplace_back(outer + "layers[" + std::to_string(j) + "].", &layer.layers[j].thickness_nm);
        }
    }
    const auto place = static_cast<std::size_t>(dice.whole(0, static_cast<int>(thicknesses.size()) - 1));
    const double from_nm = dice.between(50.0, 400.0, 10.0);
    *thicknesses[place].second = from_nm;
    const double to_nm = from_nm + dice.between(50.0, 300.0, 1.0);
    scene.y = {thicknesses[place].first + "thickness_nm", from_nm, to_nm, place};
}

ModelScene random_one(int index) {
    constexpr std::array<double, 3> bounds{1.0, 0.1, 0.02};
    Dice dice(0x6c61796572ULL * 1000 + static_cast<std::uint64_t>(index));
    ModelScene scene;
    scene.name = numbered('l', index);
    const Index incident = random_incident(dice), substrate = random_substrate(dice, incident);
    const double kind = dice.unit();
    if (kind < 0.5) {
        Film film = random_film(dice);
        film.incident = incident;
        film.substrate = substrate;
        scene.mechanism = film;
    } else {
        scene.mechanism = Stack{incident, kind < 0.75 ? some_layers(dice) : some_periods(dice), substrate, 0.0};
    }
    if (dice.chance(0.4)) scene.illuminant = dice.chance(0.5) ? "A" : "FL11";
    scene.observer_deg = dice.chance(0.25) ? 10 : 2;
    constexpr std::array<ModelAxis, 3> axes{ModelAxis::sqrt_cos_theta, ModelAxis::cos_theta, ModelAxis::theta_deg};
    scene.x = axes[static_cast<std::size_t>(dice.whole(0, 2))];
    scene.max_de00 = bounds[static_cast<std::size_t>(index % 3)];
    // At the coarsest bound: two axes may take a million texels at another.
    if (index % 12 == 3) add_second_axis(dice, scene);
    return scene;
}

}  // namespace

std::vector<ModelScene> random_layers() {
    std::vector<ModelScene> scenes;
    for (int index = 0; index < random_layers_count; ++index) scenes.push_back(random_one(index));
    return scenes;
}

}  // namespace nacre::reference
