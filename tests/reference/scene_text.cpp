#include <array>
#include <cstdio>
#include <stdexcept>

#include "reference/materials.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

// All digits: the program reads the very double that the model holds.
std::string digits(double number) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

std::string index_text(const Index& index) {
    if (is_named(index)) return '"' + index.curve->name + '"';
    if (index.curve) throw std::runtime_error("a table has no text here");
    const std::string n = digits(index.constant.real());
    return index.constant.imag() == 0.0 ? n : "{ n = " + n + ", k = " + digits(index.constant.imag()) + " }";
}

std::string layer_text(const Layer& layer) {
    return "{ index = " + index_text(layer.index) + ", thickness_nm = " + digits(layer.thickness_nm) + " }, ";
}

std::string mechanism_text(const Palette& palette) {
    std::string text = "shape = " + digits(palette.shape) + "\npicks = [\n";
    for (const Pick& pick : palette.picks) {
        text += "    { angle_deg = " + digits(pick.angle_deg) + ", peak_nm = " + digits(pick.lobe.peak_nm) +
                ", width_nm = " + digits(pick.lobe.width_nm) + ", height = " + digits(pick.lobe.height);
        if (pick.lobe.floor != 0.0) text += ", floor = " + digits(pick.lobe.floor);
        if (pick.lobe.flatness != 0.0) text += ", flatness = " + digits(pick.lobe.flatness);
        text += " },\n";
    }
    return text + "]\n";
}

std::string mechanism_text(const Film& film) {
    return "mechanism = \"film\"\nincident = " + index_text(film.incident) + "\nindex = " + index_text(film.index) +
           "\nthickness_nm = " + digits(film.thickness_nm) + "\nsubstrate = " + index_text(film.substrate) + "\n";
}

std::string mechanism_text(const Stack& stack) {
    std::string text = "mechanism = \"stack\"\nincident = " + index_text(stack.incident) + "\nlayers = [\n";
    for (const Layer& layer : stack.layers) {
        text += "    ";
        if (layer.repeat > 0) text += "{ repeat = " + std::to_string(layer.repeat) + ", layers = [ ";
        if (layer.repeat == 0) text += layer_text(layer);
        for (const Layer& member : layer.layers) text += layer_text(member);
        text += layer.repeat > 0 ? "] },\n" : "\n";
    }
    return text + "]\nsubstrate = " + index_text(stack.substrate) + "\n";
}

std::string mechanism_text(const Mechanism& mechanism) {
    if (const auto* palette = std::get_if<Palette>(&mechanism)) return mechanism_text(*palette);
    if (const auto* film = std::get_if<Film>(&mechanism)) return mechanism_text(*film);
    return mechanism_text(std::get<Stack>(mechanism));
}

// Of bases those that are numbers or names.
std::string effects_text(const Mechanism& mechanism) {
    std::string text;
    double spread_nm = 0.0;
    if (const auto* film = std::get_if<Film>(&mechanism)) spread_nm = film->thickness_spread_nm;
    if (const auto* stack = std::get_if<Stack>(&mechanism)) spread_nm = stack->thickness_spread_nm;
    if (spread_nm > 0.0) text += "thickness_spread_nm = " + digits(spread_nm) + "\n";
    const Relief& relief = mechanism.effects.relief;
    if (relief.tilt_deg > 0.0) text += "tilt_deg = " + digits(relief.tilt_deg) + "\n";
    if (relief.roughness > 0.0) text += "roughness = " + digits(relief.roughness) + "\n";
    if (!mechanism.effects.base) return text;
    if (const auto* grey = std::get_if<GreyBase>(&*mechanism.effects.base))
        return text + "base = " + digits(grey->reflectance) + "\n";
    return text + "base = { metal = " + index_text(std::get<MetalBase>(*mechanism.effects.base).metal) + " }\n";
}

const char* axis_name(ModelAxis axis) {
    if (axis == ModelAxis::theta_deg) return "theta_deg";
    return axis == ModelAxis::cos_theta ? "cos_theta" : "sqrt_cos_theta";
}

}  // namespace

std::optional<ModelScene> seen_through(ModelScene scene) {
    const Mechanism& mechanism = scene.mechanism;
    if (!std::holds_alternative<Film>(mechanism) && !std::holds_alternative<Stack>(mechanism) &&
        !std::holds_alternative<Crystal>(mechanism))
        return std::nullopt;
    scene.name += "_t";
    scene.mechanism.effects.base.reset();
    scene.mechanism.effects.observed = Observed::transmittance;
    return scene;
}

std::string numbered(char kind, int index) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%c%03d", kind, index);
    return name.data();
}

std::string scene_text(const ModelScene& scene, const std::optional<FixedLut>& fixed) {
    std::string text = "nacre = 1\n[light]\nilluminant = \"" + scene.illuminant + "\"\nobserver = \"" +
                       (scene.observer_deg == 10 ? "cie1964_10deg" : "cie1931_2deg") + "\"\n[material." + scene.name +
                       "]\n" + mechanism_text(scene.mechanism) + effects_text(scene.mechanism) + "[lut." + scene.name +
                       "]\nmaterial = \"" + scene.name + "\"\nx = \"" + axis_name(scene.x) + "\"\n";
    if (scene.y) {
        text += "y = { parameter = \"" + scene.y->name + "\", from = " + digits(scene.y->from) +
                ", to = " + digits(scene.y->to) + " }\n";
    }
    if (scene.mechanism.effects.observed == Observed::transmittance) text += "quantity = \"transmittance\"\n";
    if (fixed) {
        const std::string width = std::to_string(fixed->width);
        text += "size = " + (scene.y ? "[" + width + ", " + std::to_string(fixed->height) + "]" : width) + "\n";
        text += std::string("format = ") + (fixed->format == StoredAs::half_float ? "\"half\"" : "\"float\"") + "\n";
    }
    return text;
}

}  // namespace nacre::reference
