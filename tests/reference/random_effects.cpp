#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "reference/dice.h"
#include "reference/materials.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

Index random_metal(Dice& dice) {
    constexpr std::array<const char*, 4> metals{"ag", "au", "al", "cr"};
    return tabulated_index(metals[static_cast<std::size_t>(dice.whole(0, 3))]);
}

// n = A + B / L^2; flint glass has a B of some 1e-2 um^2.
Index cauchy(double n, double strength_um2) {
    IndexCurve curve;
    curve.name = "cauchy";
    curve.n = IndexFormula{5, {n, strength_um2, -2.0}};
    curve.first_nm = 100.0;
    curve.last_nm = 2000.0;
    return Index(std::make_shared<const IndexCurve>(std::move(curve)));
}

Index random_glass(Dice& dice, double low = 1.3, double high = 2.4) {
    const double n = dice.between(low, high);
    return dice.chance(0.4) ? cauchy(n, dice.of_any_size(1e-6, 2e-2)) : Index(n);
}

// From what a window takes to what a dye takes.
Index random_layer(Dice& dice) {
    if (dice.chance(0.05)) return tabulated_index("melanin");
    if (!dice.chance(0.35)) return random_glass(dice);
    const double k = dice.of_any_size(1e-8, 0.3);
    return RefractiveIndex(dice.between(1.3, 2.4), k);
}

Base random_base(Dice& dice) {
    switch (dice.whole(0, 4)) {
        case 0:
            return GreyBase{dice.of_any_size(1e-6, 1.0)};
        case 1:
            return RgbBase{{0.5, 0.5, 0.5}, {dice.between(-8, 8), dice.between(-8, 8), dice.between(-3, 3)}};
        case 2:
            return SpectrumBase{{{360.0, 480.0, 520.0, 640.0, 830.0},
                                 {dice.unit(), dice.unit(), dice.unit(), dice.unit(), dice.unit()}}};
        case 3:
            return PigmentBase{tabulated_index("melanin"), dice.of_any_size(0.01, 10.0), dice.between(0.01, 1.0)};
        default:
            return MetalBase{random_metal(dice)};
    }
}

void refine_layers(Dice& dice, Mechanism& mechanism, bool may_have_base) {
    Effects& effects = mechanism.effects;
    if (may_have_base && dice.chance(0.6)) effects.base = random_base(dice);
    if (dice.chance(0.35)) effects.relief.tilt_deg = dice.of_any_size(0.02, 25.0);
    if (dice.chance(0.3)) effects.polarisation = dice.chance(0.5) ? Polarisation::s : Polarisation::p;
}

Mechanism random_film(Dice& dice) {
    Film film;
    film.index = random_layer(dice);
    film.thickness_nm = dice.between(60.0, 600.0);
    const bool is_on_metal = dice.chance(0.2);
    film.substrate = is_on_metal ? random_metal(dice) : dice.chance(0.25) ? Index(1.0) : random_glass(dice);
    if (dice.chance(0.35)) film.thickness_spread_nm = dice.of_any_size(0.01, 0.15 * film.thickness_nm);
    // A free film's fringes at grazing are too sharp for the judge's mean over thicknesses.
    if (film.thickness_spread_nm > 0.0 && same(film.substrate, 1.0)) film.substrate = Index(1.5);
    Mechanism mechanism = film;
    refine_layers(dice, mechanism, !is_on_metal);
    return mechanism;
}

Layer layer_of(const Index& index, double thickness_nm, bool is_incoherent = false) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    layer.is_incoherent = is_incoherent;
    return layer;
}

Mechanism random_stack(Dice& dice) {
    Stack stack;
    stack.substrate = random_glass(dice, 1.4, 1.9);
    // A coating below a window, or on top of one that is clear or dark.
    if (dice.chance(0.4)) {
        const double k = dice.chance(0.5) ? 0.0 : dice.of_any_size(1e-9, 1e-3);
        stack.layers.push_back(layer_of(RefractiveIndex(dice.between(1.4, 1.6), k), 1e6, true));
        if (dice.chance(0.5)) stack.layers.insert(stack.layers.begin(), layer_of(random_layer(dice), 120.0));
    }
    const bool is_spread = dice.chance(0.3);
    const int most = is_spread ? 1 : 5;
    for (int i = dice.whole(1, most); i > 0; --i) {
        const double thickness_nm = dice.between(30.0, 200.0);
        stack.layers.push_back(layer_of(random_layer(dice), thickness_nm));
    }
    const bool has_window =
        std::any_of(stack.layers.begin(), stack.layers.end(), [](const Layer& layer) { return layer.is_incoherent; });
    // What reflects totally above a window is beyond the judge.
    if (has_window) stack.substrate = dice.between(1.4, 1.6);
    if (is_spread) stack.thickness_spread_nm = dice.of_any_size(0.01, 15.0);
    Mechanism mechanism = stack;
    refine_layers(dice, mechanism, true);
    return mechanism;
}

Mechanism random_crystal(Dice& dice) {
    Crystal crystal;
    const bool is_inverse = dice.chance(0.4);
    crystal.sphere = is_inverse ? Index(1.0) : random_glass(dice, 1.4, 1.7);
    crystal.medium = is_inverse ? random_glass(dice, 1.4, 2.2) : Index(dice.between(1.0, 1.35));
    if (dice.chance(0.3))
        crystal.medium = RefractiveIndex(index_at(crystal.medium, 555.0).real(), dice.of_any_size(1e-7, 0.02));
    crystal.diameter_nm = dice.between(180.0, 300.0);
    crystal.planes = dice.whole(3, 12);
    crystal.substrate = random_glass(dice, 1.3, 1.6);
    if (dice.chance(0.3)) crystal.thickness_spread_nm = dice.of_any_size(0.01, 4.0);
    Mechanism mechanism = crystal;
    refine_layers(dice, mechanism, true);
    return mechanism;
}

Mechanism random_scatter(Dice& dice) {
    Scatter scatter;
    constexpr std::array models{ScatterModel::rayleigh, ScatterModel::mie, ScatterModel::quasi_ordered};
    scatter.model = models[static_cast<std::size_t>(dice.whole(0, 2))];
    const bool is_tiny = scatter.model == ScatterModel::rayleigh;
    scatter.radius_nm = is_tiny ? dice.between(5.0, 30.0) : dice.between(40.0, 180.0);
    scatter.medium = dice.between(1.3, 1.6);
    scatter.particle = dice.chance(0.3) ? Index(1.0) : random_glass(dice, 1.4, 2.2);
    if (dice.chance(0.4))
        scatter.particle = RefractiveIndex(index_at(scatter.particle, 555.0).real(), dice.of_any_size(1e-9, 0.1));
    // Not the medium's own: then nothing is scattered.
    const double contrast = index_at(scatter.particle, 555.0).real() - index_at(scatter.medium, 555.0).real();
    if (std::abs(contrast) < 0.03) scatter.medium = index_at(scatter.medium, 555.0).real() + 0.1;
    scatter.volume_fraction = scatter.model == ScatterModel::quasi_ordered ? dice.between(0.1, 0.45) : 0.01;
    scatter.thickness_um = dice.of_any_size(0.3, 30.0);
    if (dice.chance(0.6)) scatter.radius_spread = dice.of_any_size(1e-4, 0.3);
    Mechanism mechanism = scatter;
    if (dice.chance(0.3)) mechanism.effects.polarisation = dice.chance(0.5) ? Polarisation::s : Polarisation::p;
    return mechanism;
}

Mechanism random_grating(Dice& dice) {
    Grating grating;
    grating.period_nm = dice.between(600.0, 1800.0);
    grating.grooves = dice.whole(4, 30);
    if (dice.chance(0.5)) {
        grating.profile = GratingProfile::given;
        // Beyond the first, orders of any size.
        grating.efficiency = {dice.between(0.1, 0.3)};
        for (int i = dice.whole(0, 2); i > 0; --i) grating.efficiency.push_back(dice.of_any_size(1e-6, 0.09));
    } else {
        grating.profile = dice.chance(0.5) ? GratingProfile::lamellar : GratingProfile::sinusoidal;
        grating.depth_nm = dice.of_any_size(1.0, 200.0);
        grating.land = dice.between(0.3, 0.7);
    }
    if (dice.chance(0.5)) grating.coat = random_metal(dice);
    if (dice.chance(0.3)) grating.orders = {1, 2};
    return grating;
}

Mechanism random_palette(Dice& dice) {
    Palette palette;
    double angle_deg = dice.between(0.0, 20.0);
    for (int i = dice.whole(2, 3); i > 0; --i) {
        palette.picks.push_back(
            {angle_deg, {dice.between(440.0, 640.0), dice.between(60.0, 140.0), dice.between(0.3, 1.0)}});
        angle_deg += dice.between(15.0, 35.0);
    }
    Mechanism mechanism = palette;
    mechanism.effects.relief.tilt_deg = dice.of_any_size(0.02, 25.0);
    return mechanism;
}

ModelScene random_one(int index) {
    constexpr std::array<double, 3> bounds{1.0, 0.3, 0.1};
    Dice dice(0x656666656374ULL * 1000 + static_cast<std::uint64_t>(index));
    ModelScene scene;
    scene.name = numbered('e', index);
    const double kind = dice.unit();
    scene.mechanism = kind < 0.4    ? random_film(dice)
                      : kind < 0.6  ? random_stack(dice)
                      : kind < 0.68 ? random_crystal(dice)
                      : kind < 0.83 ? random_scatter(dice)
                      : kind < 0.93 ? random_grating(dice)
                                    : random_palette(dice);
    // Every other tilted surface is a rough one instead.
    Relief& relief = scene.mechanism.effects.relief;
    if (index % 2 == 0 && relief.tilt_deg > 0.0) relief = {0.0, relief.tilt_deg / 25.0};
    if (dice.chance(0.3)) scene.illuminant = dice.chance(0.5) ? "A" : "FL11";
    scene.observer_deg = dice.chance(0.25) ? 10 : 2;
    scene.max_de00 = bounds[static_cast<std::size_t>(index % 3)];
    return scene;
}

}  // namespace

std::vector<ModelScene> random_effects() {
    std::vector<ModelScene> scenes;
    for (int index = 0; index < random_effects_count; ++index) scenes.push_back(random_one(index));
    return scenes;
}

}  // namespace nacre::reference
