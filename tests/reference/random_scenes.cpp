#include "reference/random_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>

namespace nacre::reference {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every compiler and library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
    /// In [low, high], a multiple of step (a power of ten below 1 gives a short decimal).
    double between(double low, double high, double per_unit) {
        return std::round((low + unit() * (high - low)) * per_unit) / per_unit;
    }
    bool chance(double probability) { return unit() < probability; }
    template <typename T, std::size_t count>
    const T& one_of(const std::array<T, count>& things) {
        return things[static_cast<std::size_t>(unit() * static_cast<double>(count))];
    }

private:
    std::uint64_t state_;
};

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

std::vector<ModelPick> random_picks(Dice& dice) {
    const double kind = dice.unit();
    const int count = kind < 0.70 ? 2 : kind < 0.87 ? 3 : kind < 0.97 ? 4 : 1;
    // One pick alone is two equal ones: a scene has to have two.
    const std::vector<double> angles = random_angles(dice, std::max(count, 2));
    std::vector<double> peaks;
    for (std::size_t i = 0; i < angles.size(); ++i) peaks.push_back(dice.between(380.0, 720.0, 10.0));
    if (dice.chance(0.75)) std::sort(peaks.begin(), peaks.end(), std::greater<>());
    const double common_width_nm = random_width_nm(dice);
    const bool same_width = dice.chance(0.3);

    std::vector<ModelPick> picks;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double width_nm = same_width ? common_width_nm : random_width_nm(dice);
        picks.push_back({angles[i], peaks[i], width_nm, random_height(dice)});
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

SceneModel random_scene(int index) {
    Dice dice(0x6e61637265ULL * 1000 + static_cast<std::uint64_t>(index));
    SceneModel scene;
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "s%03d", index);
    scene.name = name.data();
    scene.picks = random_picks(dice);
    scene.shape = dice.between(0.0, 1.0, 100.0);
    if (dice.chance(0.5)) scene.illuminant = dice.one_of<std::string, 5>({"D50", "A", "E", "FL2", "FL11"});
    scene.observer_deg = dice.chance(0.3) ? 10 : 2;
    if (dice.chance(0.3)) scene.x = dice.chance(0.5) ? ModelAxis::cos_theta : ModelAxis::theta_deg;
    if (index % 10 == 9) scene.y = random_parameter(dice);
    return scene;
}

const char* axis_name(ModelAxis axis) {
    switch (axis) {
        case ModelAxis::sqrt_cos_theta:
            return "sqrt_cos_theta";
        case ModelAxis::cos_theta:
            return "cos_theta";
        case ModelAxis::theta_deg:
            return "theta_deg";
    }
    return "";
}

// All digits: the program reads the very double that the model holds.
std::string digits(double number) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

}  // namespace

std::vector<SceneModel> random_scenes() {
    std::vector<SceneModel> scenes;
    for (int index = 0; index < random_scene_count; ++index) scenes.push_back(random_scene(index));
    return scenes;
}

std::string scene_text(const SceneModel& scene, const std::optional<FixedLut>& fixed) {
    std::string text = "nacre = 1\n[light]\nilluminant = \"" + scene.illuminant + "\"\nobserver = \"" +
                       (scene.observer_deg == 10 ? "cie1964_10deg" : "cie1931_2deg") + "\"\n[material." + scene.name +
                       "]\nshape = " + digits(scene.shape) + "\npicks = [\n";
    for (const ModelPick& pick : scene.picks) {
        text += "    { angle_deg = " + digits(pick.angle_deg) + ", peak_nm = " + digits(pick.peak_nm) +
                ", width_nm = " + digits(pick.width_nm) + ", height = " + digits(pick.height) + " },\n";
    }
    text += "]\n[lut." + scene.name + "]\nmaterial = \"" + scene.name + "\"\nx = \"" + axis_name(scene.x) + "\"\n";
    if (scene.y) {
        text += "y = { parameter = \"" + scene.y->name + "\", from = " + digits(scene.y->from) +
                ", to = " + digits(scene.y->to) + " }\n";
    }
    if (fixed) {
        const std::string width = std::to_string(fixed->width);
        text += "size = " + (scene.y ? "[" + width + ", " + std::to_string(fixed->height) + "]" : width) + "\n";
        text += std::string("format = ") + (fixed->format == StoredAs::half_float ? "\"half\"" : "\"float\"") + "\n";
    }
    return text;
}

}  // namespace nacre::reference
