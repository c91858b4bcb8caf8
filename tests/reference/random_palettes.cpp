#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "reference/dice.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

constexpr double smallest_distance_deg = 5.0;

std::vector<double> random_angles(Dice& dice, int count) {
    std::vector<double> angles;
    while (static_cast<int>(angles.size()) < count) {
        const double angle = angles.empty() && dice.chance(0.4) ? 0.0 : dice.between(0.0, 85.0, 10.0);
        const bool apart = std::all_of(angles.begin(), angles.end(),
                                       [&](double other) { return std::abs(other - angle) >= smallest_distance_deg; });
        if (apart) angles.push_back(angle);
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

double random_width_nm(Dice& dice) {
    if (dice.chance(0.05)) return dice.between(3.0, 15.0, 10.0);
    // Even in the logarithm: lobes of insects are some tens of nanometres wide.
    return std::round(15.0 * std::pow(20.0, dice.unit()) * 10.0) / 10.0;
}

double random_height(Dice& dice) {
    return dice.chance(0.04) ? 0.0 : dice.between(0.05, 1.0, 100.0);
}

std::vector<Pick> random_picks(Dice& dice) {
    const double kind = dice.unit();
    const int count = kind < 0.70 ? 2 : kind < 0.87 ? 3 : kind < 0.97 ? 4 : 1;
    // One pick alone is two equal ones: a scene has to have two.
    const std::vector<double> angles = random_angles(dice, std::max(count, 2));
    std::vector<double> peaks;
    for (std::size_t i = 0; i < angles.size(); ++i) peaks.push_back(dice.between(380.0, 720.0, 10.0));
    if (dice.chance(0.75)) std::sort(peaks.begin(), peaks.end(), std::greater<>());
    const double common_width_nm = random_width_nm(dice);
    const bool same_width = dice.chance(0.3);

    std::vector<Pick> picks;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double width_nm = same_width ? common_width_nm : random_width_nm(dice);
        picks.push_back({angles[i], {peaks[i], width_nm, random_height(dice)}});
    }
    if (count == 1) {
        picks[1] = picks[0];
        picks[1].angle_deg = angles[1];
    }
    return picks;
}

ModelParameter random_parameter(Dice& dice) {
    const double kind = dice.unit();
    if (kind < 0.3) return {"width_nm", dice.between(20.0, 80.0, 1.0), dice.between(100.0, 200.0, 1.0)};
    if (kind < 0.6) {
        const double from = dice.between(400.0, 600.0, 1.0);
        return {"peak_nm", from, from + dice.between(20.0, 100.0, 1.0)};
    }
    if (kind < 0.8) return {"height", dice.between(0.1, 0.4, 100.0), dice.between(0.6, 1.0, 100.0)};
    return {"shape", dice.between(0.0, 0.3, 100.0), dice.between(0.6, 1.0, 100.0)};
}

ModelScene random_palette(int index) {
    Dice dice(0x6e61637265ULL * 1000 + static_cast<std::uint64_t>(index));
    ModelScene scene;
    Palette palette;
    scene.name = numbered('s', index);
    palette.picks = random_picks(dice);
    palette.shape = dice.between(0.0, 1.0, 100.0);
    scene.mechanism = palette;
    scene.x = ModelAxis::sqrt_cos_theta;
    if (dice.chance(0.5)) scene.illuminant = dice.one_of<std::string, 5>({"D50", "A", "E", "FL2", "FL11"});
    scene.observer_deg = dice.chance(0.3) ? 10 : 2;
    if (dice.chance(0.3)) scene.x = dice.chance(0.5) ? ModelAxis::cos_theta : ModelAxis::theta_deg;
    if (index % 10 == 9) scene.y = random_parameter(dice);
    return scene;
}

}  // namespace

std::vector<ModelScene> random_palettes() {
    std::vector<ModelScene> scenes;
    for (int index = 0; index < random_palettes_count; ++index) scenes.push_back(random_palette(index));
    return scenes;
}

}  // namespace nacre::reference
