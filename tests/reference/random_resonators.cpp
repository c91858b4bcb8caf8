#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "reference/dice.h"
#include "reference/materials.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

constexpr std::array<const char*, 3> mirrors{"ag", "au", "al"};

// @param place  0 to 1 through the kind, so that its range is walked evenly
Mechanism gap(Dice& dice, double place) {
    Film film;
    film.incident = dice.between(1.33, 2.0, 100.0);
    film.index = 1.0;
    film.thickness_nm = std::round(100.0 + 1100.0 * place);
    film.substrate = named_index(dice.one_of(mirrors));
    return film;
}

// Light comes through a thin metal, or from a prism through the thinnest.
Mechanism cavity(Dice& dice, double place) {
    Stack stack;
    stack.incident = dice.chance(0.25) ? Index(dice.between(1.33, 1.8, 100.0)) : Index(1.0);
    const Index metal = named_index(dice.one_of(mirrors));
    const double top_nm = dice.between(8.0, 50.0, 1.0);
    const Index inside = dice.chance(0.3)   ? named_index("sio2")
                         : dice.chance(0.3) ? Index(1.0)
                                            : Index(dice.between(1.3, 2.4, 100.0));
    stack.layers = {layer_of(metal, top_nm), layer_of(inside, std::round(60.0 + 1500.0 * place * place))};
    stack.substrate = metal;
    if (dice.chance(0.4)) {
        stack.layers.push_back(layer_of(metal, dice.between(15.0, 60.0, 1.0)));
        stack.substrate = dice.chance(0.5) ? Index(1.5) : named_index("sio2");
    }
    return stack;
}

struct QuarterWaves {
    Layer high, low;
};

QuarterWaves quarter_waves(Dice& dice, double centre_nm) {
    const double n_high = dice.between(1.8, 2.6, 100.0);
    const bool is_glass = dice.chance(0.4);
    const double n_low = is_glass ? 1.46 : dice.between(1.35, 1.6, 100.0);
    const auto quarter = [&](double n) { return std::round(10.0 * centre_nm / 4.0 / n) / 10.0; };
    return {layer_of(n_high, quarter(n_high)), layer_of(is_glass ? named_index("sio2") : Index(n_low), quarter(n_low))};
}

// Two mirrors around a layer of about half a wave, or of several.
Mechanism mirror_with_defect(Dice& dice, double place) {
    const QuarterWaves waves = quarter_waves(dice, dice.between(420.0, 680.0, 0.2));
    const int pairs = 2 + static_cast<int>(7.0 * place);
    Layer defect = dice.chance(0.5) ? waves.high : waves.low;
    defect.thickness_nm = std::round(10.0 * defect.thickness_nm * dice.between(1.2, 2.8)) / 10.0;
    if (dice.chance(0.25)) defect.thickness_nm *= dice.whole(2, 4);
    return Stack{1.0,
                 {periods_of(pairs, waves.high, waves.low), defect, periods_of(pairs, waves.low, waves.high)},
                 dice.chance(0.5) ? Index(1.5) : named_index("sio2"),
                 0.0};
}

// One edge of the band where the eye sees best.
Mechanism long_stack(Dice& dice, double place) {
    const double centre_nm = dice.chance(0.5) ? dice.between(430.0, 500.0, 0.2) : dice.between(600.0, 720.0, 0.2);
    const QuarterWaves waves = quarter_waves(dice, centre_nm);
    const int pairs = 6 + static_cast<int>(20.0 * place);
    const Index incident = dice.chance(0.3) ? Index(dice.between(1.33, 1.52, 100.0)) : Index(1.0);
    return Stack{incident,
                 {periods_of(pairs, waves.high, waves.low), waves.high},
                 dice.chance(0.3) ? incident : Index(1.5),
                 0.0};
}

// From no film at all to 20 um.
Mechanism film(Dice& dice, double place) {
    Film film;
    film.incident = 1.0;
    film.thickness_nm = std::round(20000.0 * place * place * place);
    film.index = dice.chance(0.3) ? named_index("water") : Index(dice.between(1.3, 2.4, 100.0));
    const double behind = dice.unit();
    film.substrate = behind < 0.3   ? Index(1.0)
                     : behind < 0.7 ? Index(dice.between(1.4, 1.9, 100.0))
                                    : named_index(dice.one_of(mirrors));
    return film;
}

bool is_metal(const Index& index) {
    return is_named(index) && std::find(mirrors.begin(), mirrors.end(), index.curve->name) != mirrors.end();
}

void refine(Dice& dice, Mechanism& mechanism) {
    Film* film = std::get_if<Film>(&mechanism);
    const Index& substrate = film != nullptr ? film->substrate : std::get<Stack>(mechanism).substrate;
    const int kind = dice.whole(0, 2);
    // Of two faces that mirror, as a free film's do towards grazing, the model's mean over thicknesses is too coarse.
    if (kind == 0 && film != nullptr && film->thickness_nm > 20.0 && !same(film->substrate, film->incident)) {
        film->thickness_spread_nm = std::round(film->thickness_nm * dice.between(0.01, 0.08));
    } else if (kind == 1 && !is_metal(substrate) && (film == nullptr || film->thickness_nm < 1500.0)) {
        if (dice.chance(0.6))
            mechanism.effects.base = GreyBase{dice.between(0.02, 0.9, 100.0)};
        else
            mechanism.effects.base = MetalBase{named_index(dice.one_of(mirrors))};
    } else {
        mechanism.effects.relief.tilt_deg = dice.between(0.5, 20.0, 10.0);
    }
}

using Kind = Mechanism (*)(Dice&, double);

ModelScene random_one(int index) {
    constexpr std::array<Kind, 5> kinds{gap, cavity, mirror_with_defect, long_stack, film};
    constexpr int of_a_kind = random_resonators_count / static_cast<int>(kinds.size());
    Dice dice(0x7265736f6eULL * 1000 + static_cast<std::uint64_t>(index));
    ModelScene scene;
    scene.name = numbered('r', index);
    const auto kind = static_cast<std::size_t>(index) % kinds.size();
    const int of_its_kind = index / static_cast<int>(kinds.size());
    scene.mechanism = kinds[kind](dice, static_cast<double>(of_its_kind) / (of_a_kind - 1));
    if (dice.chance(0.3)) refine(dice, scene.mechanism);
    if (dice.chance(0.3)) scene.illuminant = dice.chance(0.5) ? "A" : "FL11";
    scene.x = dice.chance(0.2)   ? ModelAxis::theta_deg
              : dice.chance(0.2) ? ModelAxis::cos_theta
                                 : ModelAxis::sqrt_cos_theta;
    return scene;
}

}  // namespace

std::vector<ModelScene> random_resonators() {
    std::vector<ModelScene> scenes;
    for (int index = 0; index < random_resonators_count; ++index) scenes.push_back(random_one(index));
    return scenes;
}

}  // namespace nacre::reference
