#include "pipeline/baked_lut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/disk/hash.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre_version.h"

namespace nacre {
namespace {

// As scenes write it, less the quotes: `sqrt_cos_theta`, `{ parameter = "width_nm", from = 20, to = 200 }`.
std::string axis_text(const Axis& axis) {
    return axis.is_angle() ? std::string(axis.kind->name) : axis_toml(axis);
}

// To a millionth of a degree: the bits beyond are those of the machine's sine.
double rounded_angle(double angle_deg) {
    return std::round(angle_deg * 1e6) / 1e6;
}

std::string angle_text(double angle_deg) {
    return number_text(rounded_angle(angle_deg));
}

std::optional<std::array<float, 8>> chromaticities_of(const ColourTransform& transform) {
    auto primaries = primaries_by_interop_id(transform.interop_id());
    if (!primaries && transform.linear_matrix()) primaries = primaries_of(*transform.linear_matrix());
    if (!primaries) return std::nullopt;
    std::array<float, 8> numbers{};
    std::size_t i = 0;
    for (const Chromaticity& c : {primaries->red, primaries->green, primaries->blue, primaries->white}) {
        numbers[i++] = static_cast<float>(c.x);
        numbers[i++] = static_cast<float>(c.y);
    }
    return numbers;
}

// Three digits, upwards: more would differ from one machine's sine to another's, less would promise too much.
double rounded_up(double error) {
    if (!(error > 0.0) || !std::isfinite(error)) return error;
    const double unit = std::pow(10.0, std::floor(std::log10(error)) - 2.0);
    // By way of text, so that 0.0213 is the number that is written 0.0213.
    char text[32];
    std::snprintf(text, sizeof text, "%.2e", std::ceil(error / unit * (1.0 - 1e-9)) * unit);
    return std::strtod(text, nullptr);
}

// "base simulated, tilt negligible (0.0021 of 0.005)".
std::string effects_text(const std::vector<EffectChoice>& effects) {
    std::string text;
    for (const EffectChoice& choice : effects) {
        text += (text.empty() ? "" : ", ") + std::string(row_of(choice.effect).name) +
                (choice.is_simulated ? " simulated"
                 : choice.is_given   ? " left out"
                                     : " negligible");
        if (choice.is_simulated) continue;
        text += " (" + number_text(rounded_up(choice.contribution));
        if (!choice.is_given) text += " of " + number_text(choice.share);
        text += ")";
    }
    return text;
}

LutHeader make_header(const SettledLut& settled, const ColourSettings& colour, const ColourSource& source,
                      const ColourTransform& transform, const BakedLut& baked) {
    const PlannedLut& lut = settled.lut;
    const Job& job = lut.job;
    const LightSettings& light = job.light->settings;
    const std::string scene = scene_toml(lut, colour);
    LutHeader header;
    header.software = "nacre " + std::string(nacre_version());
    header.interop_id = transform.interop_id();
    header.chromaticities = chromaticities_of(transform);
    const auto add = [&](const char* name, std::string value) { header.nacre.emplace_back(name, std::move(value)); };
    add("version", std::string(nacre_version()));
    add("lut", lut.name);
    add("material", job.material.name);
    add("mechanism", std::string(mechanism_name(job.material.mechanism)));
    add("axisX", axis_text(job.x));
    if (job.y) add("axisY", axis_text(*job.y));
    add("size", std::to_string(job.width) + " x " + std::to_string(job.height));
    add("format", std::string(name_of(format_words, lut.format)));
    add("sampling",
        "texel i is the value at i / (N - 1); texture coordinate (x * (N - 1) + 0.5) / N; linear, clamp, no mip-maps");
    add("illuminant", light.illuminant);
    add("observer", std::string(name_of(observer_words, light.observer)));
    add("adapt", std::string(name_of(adaptation_words, light.adaptation)));
    add("rangeNm", std::to_string(light.first_nm) + " " + std::to_string(light.last_nm));
    add("integration", integration_text(job));
    if (!baked.picked.empty()) add("picked", picked_text(baked.picked));
    if (!settled.effects.empty()) add("effects", effects_text(settled.effects));
    add("accuracyAsked", lut.wish.has_bound ? number_text(lut.wish.max_de00) : "none");
    add("accuracyReached", baked.reached ? number_text(*baked.reached) : "unknown");
    add("colourSpace", transform.target());
    add("colourConfig", source.config);
    add("colourConfigHash", source.hash);
    add("colourTransform", transform.to_ctf());
    add("gamut", std::string(name_of(gamut_words, colour.gamut)));
    add("gamutOutside", std::to_string(baked.gamut.outside));
    // Where negative components are kept the file has them itself.
    if (colour.gamut != Gamut::keep) add("gamutMostNegative", number_text(-rounded_up(-baked.gamut.most_negative)));
    if (baked.clamped.below_deg) add("clampedBelowDeg", angle_text(*baked.clamped.below_deg));
    if (baked.clamped.above_deg) add("clampedAboveDeg", angle_text(*baked.clamped.above_deg));
    add("scene", scene);
    add("sceneHash", hash_text(scene));
    return header;
}

GamutRule gamut_rule(const ColourTransform& transform, Gamut gamut) {
    if (gamut == Gamut::compress && !transform.linear_matrix()) {
        throw Error("gamut = \"compress\" needs a linear space, and " + transform.target() +
                    " is none; use clip or keep");
    }
    return {gamut, transform.linear_matrix()};
}

nlohmann::ordered_json axis_json(const Axis& axis) {
    if (axis.is_angle()) return {{"axis", axis.kind->name}};
    return {{"parameter", axis.parameter.name}, {"from", axis.from}, {"to", axis.to}};
}

}  // namespace

std::string_view nacre_version() {
    return NACRE_VERSION;
}

Encoding lut_encoding(const ColourTransform& transform, Gamut gamut) {
    Encoding encoding;
    // Shared, because a std::function is copied with what it holds.
    encoding.to_rgb = [&transform,
                       rule = std::make_shared<const GamutRule>(gamut_rule(transform, gamut))](const Image<Xyz>& xyz) {
        Image<Rgb> rgb = transform.apply(xyz);
        rule->apply(rgb, xyz);
        return rgb;
    };
    if (transform.has_way_back()) {
        encoding.to_xyz = [&transform](const Image<Rgb>& rgb) { return transform.back(rgb); };
    }
    encoding.stored = stored_value;
    encoding.keeps_colours = gamut == Gamut::keep;
    return encoding;
}

BakedLut bake_lut(const SettledLut& settled, const Plan& plan, const ColourSource& source,
                  const ColourTransform& transform, const AfterRow& after_row) {
    const PlannedLut& lut = settled.lut;
    BakedLut baked;
    const Image<Xyz> xyz = bake(lut.job, after_row, &baked.work);
    baked.image = transform.apply(xyz);
    baked.gamut = gamut_report(baked.image);
    gamut_rule(transform, plan.colour.gamut).apply(baked.image, xyz);
    check_storable(baked.image, lut.format);
    for (Rgb& texel : baked.image) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b})
            texel.*component = stored_value(texel.*component, lut.format);
    }
    baked.left = gamut_report(baked.image);
    const Encoding encoding = lut_encoding(transform, plan.colour.gamut);
    if (encoding.to_xyz) {
        const Measured measured = measure(lut.job, baked.image, encoding, settled.worst);
        baked.reached = rounded_up(measured.reached + settled.predicted.spread);
        baked.work += measured.work;
    }
    if (const SceneMaterial* material = find_material(plan, lut.job.material.name)) baked.picked = material->picked;
    if (const auto* palette = std::get_if<Palette>(&lut.job.material.mechanism))
        baked.clamped = palette_clamp_bounds(*palette);
    baked.header = make_header(settled, plan.colour, source, transform, baked);
    return baked;
}

nlohmann::ordered_json picked_json(const PickedColour& picked) {
    static constexpr std::array misses{"exact", "too bright", "too saturated"};
    nlohmann::ordered_json json{{"pick", picked.pick}, {"angle_deg", picked.angle_deg}, {"colour", picked.text}};
    if (picked.lobe) {
        json["peak_nm"] = picked.lobe->peak_nm;
        json["width_nm"] = picked.lobe->width_nm;
        json["height"] = picked.lobe->height;
    }
    json["de00"] = rounded_up(picked.de00);
    json["match"] = picked.lobe       ? misses[static_cast<std::size_t>(picked.lobe->miss)]
                    : picked.is_met() ? "met"
                                      : "missed";
    return json;
}

std::string manifest_json(const SettledLut& settled, const BakedLut& baked) {
    const PlannedLut& lut = settled.lut;
    const Job& job = lut.job;
    const LightSettings& light = job.light->settings;
    const LutHeader& header = baked.header;
    nlohmann::ordered_json json;
    json["nacre"] = nacre_version();
    json["lut"] = lut.name;
    if (std::find(lut.outputs.begin(), lut.outputs.end(), LutOutput::exr) != lut.outputs.end()) {
        json["file"] = lut.name + ".exr";
    }
    json["material"] = job.material.name;
    json["mechanism"] = mechanism_name(job.material.mechanism);
    json["width"] = job.width;
    json["height"] = job.height;
    json["format"] = name_of(format_words, lut.format);
    json["x"] = axis_json(job.x);
    if (job.y) json["y"] = axis_json(*job.y);
    json["first_row"] = "smallest y";
    json["texcoord"] = "(x * (N - 1) + 0.5) / N";
    json["filter"] = "linear";
    json["wrap"] = "clamp";
    json["mipmaps"] = false;
    json["colour_space"] = header.value("colourSpace");
    if (!header.interop_id.empty()) json["color_interop_id"] = header.interop_id;
    if (header.chromaticities) {
        // Six decimals are a float's own digits here; more would be those of its neighbourhood in double.
        for (const float number : *header.chromaticities)
            json["chromaticities"].push_back(std::round(static_cast<double>(number) * 1e6) / 1e6);
    }
    json["colour_config"] = header.value("colourConfig");
    json["gamut"] = {{"rule", header.value("gamut")},
                     {"texels_outside", baked.gamut.outside},
                     {"most_negative", baked.gamut.most_negative}};
    // Of what is kept it would say the same again.
    if (header.value("gamut") != name_of(gamut_words, Gamut::keep)) {
        json["gamut"]["left"] = {{"texels_outside", baked.left.outside}, {"most_negative", baked.left.most_negative}};
    }
    json["light"] = {{"illuminant", light.illuminant},
                     {"observer", header.value("observer")},
                     {"adapt", header.value("adapt")},
                     {"range_nm", {light.first_nm, light.last_nm}},
                     {"integration", header.value("integration")}};
    nlohmann::ordered_json& accuracy = json["accuracy"];
    accuracy["max_de00"] = nullptr;
    if (lut.wish.has_bound) accuracy["max_de00"] = lut.wish.max_de00;
    accuracy["predicted"] = nullptr;
    accuracy["reached"] = nullptr;
    if (baked.reached) {
        accuracy["predicted"] = rounded_up(settled.predicted.total);
        accuracy["reached"] = *baked.reached;
    }
    for (const EffectChoice& choice : settled.effects) {
        nlohmann::ordered_json effect{{"effect", row_of(choice.effect).name},
                                      {"state", choice.is_simulated ? "simulated"
                                                : choice.is_given   ? "left out"
                                                                    : "negligible"}};
        if (!choice.is_simulated) effect["de00"] = rounded_up(choice.contribution);
        if (!choice.is_simulated && !choice.is_given) effect["share"] = choice.share;
        json["effects"].push_back(std::move(effect));
    }
    for (const PickedColour& picked : baked.picked) json["picked"].push_back(picked_json(picked));
    if (baked.clamped.below_deg) json["clamped_below_deg"] = rounded_angle(*baked.clamped.below_deg);
    if (baked.clamped.above_deg) json["clamped_above_deg"] = rounded_angle(*baked.clamped.above_deg);
    json["scene"] = header.value("scene");
    json["scene_hash"] = header.value("sceneHash");
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace nacre
