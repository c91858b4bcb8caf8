#include "pipeline/lut_header.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/disk/hash.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/axis_reader.h"
#include "pipeline/rounding.h"
#include "pipeline/version.h"

namespace nacre {
namespace {

// As scenes write it, less the quotes: `sqrt_cos_theta`, `{ parameter = "width_nm", from = 20, to = 200 }`.
std::string axis_text(const Axis& axis) {
    return axis.is_angle() ? std::string(axis.kind->name) : axis_toml(axis);
}

std::string angle_text(double angle_deg) {
    return number_text(rounded_angle(angle_deg));
}

std::optional<std::array<float, 8>> chromaticities_of(const ColourSpace& space) {
    const std::optional<RgbPrimaries> primaries = space.primaries();
    if (!primaries) return std::nullopt;
    std::array<float, 8> numbers{};
    std::size_t i = 0;
    for (const Chromaticity& c : {primaries->red, primaries->green, primaries->blue, primaries->white}) {
        numbers[i++] = static_cast<float>(c.x);
        numbers[i++] = static_cast<float>(c.y);
    }
    return numbers;
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

using Attributes = std::vector<std::pair<std::string, std::string>>;

// What the LUT is of, and how its texels lie.
void add_job(Attributes& header, const PlannedLut& lut) {
    const Job& job = lut.job;
    header.emplace_back("lut", lut.name);
    header.emplace_back("material", job.material.name);
    header.emplace_back("mechanism", std::string(mechanism_name(job.material.mechanism)));
    // A LUT that says nothing is of reflectance.
    if (is_transmittance(job.material.mechanism)) header.emplace_back("quantity", "transmittance");
    header.emplace_back("axisX", axis_text(job.x));
    if (job.y) header.emplace_back("axisY", axis_text(*job.y));
    header.emplace_back("size", std::to_string(job.width) + " x " + std::to_string(job.height));
    header.emplace_back("format", std::string(name_of(format_words, lut.format)));
    header.emplace_back("sampling",
                        "texel i is the value at i / (N - 1); texture coordinate (x * (N - 1) + 0.5) / N; linear, "
                        "clamp, no mip-maps");
}

void add_light(Attributes& header, const Job& job) {
    const LightSettings& light = job.light->settings;
    header.emplace_back("illuminant", light.illuminant);
    header.emplace_back("observer", std::string(name_of(observer_words, light.observer)));
    header.emplace_back("adapt", std::string(name_of(adaptation_words, light.adaptation)));
    header.emplace_back("rangeNm", std::to_string(light.first_nm) + " " + std::to_string(light.last_nm));
    header.emplace_back("integration", integration_text(job));
}

void add_accuracy(Attributes& header, const ChosenLut& chosen, const BakedLut& baked) {
    const AccuracyRequest& request = chosen.lut.request;
    if (!baked.picked.empty()) header.emplace_back("picked", picked_text(baked.picked));
    if (!chosen.effects.empty()) header.emplace_back("effects", effects_text(chosen.effects));
    header.emplace_back("accuracyAsked", request.has_bound ? number_text(request.max_de00) : "none");
    header.emplace_back("accuracyReached", baked.reached ? number_text(*baked.reached) : "unknown");
    if (baked.measured) {
        header.emplace_back("accuracyPoints", std::to_string(baked.measured->model_points) + " of the model, " +
                                                  std::to_string(baked.measured->reference_points) +
                                                  " of the reference");
    }
}

void add_colour(Attributes& header, Gamut gamut, const ColourSource& source, const ColourSpace& space,
                const BakedLut& baked) {
    header.emplace_back("colourSpace", space.name());
    header.emplace_back("colourConfig", source.config);
    header.emplace_back("colourConfigHash", source.hash);
    header.emplace_back("colourTransform", space.transform_text());
    header.emplace_back("gamut", std::string(name_of(gamut_words, gamut)));
    header.emplace_back("gamutOutside", std::to_string(baked.gamut.outside));
    // Where negative components are kept the file has them itself.
    if (gamut != Gamut::keep)
        header.emplace_back("gamutMostNegative", number_text(-rounded_up(-baked.gamut.most_negative)));
    if (baked.clamped.below_deg) header.emplace_back("clampedBelowDeg", angle_text(*baked.clamped.below_deg));
    if (baked.clamped.above_deg) header.emplace_back("clampedAboveDeg", angle_text(*baked.clamped.above_deg));
}

}  // namespace

LutHeader lut_header(const ChosenLut& chosen, const ColourSource& source, const ColourSpace& space,
                     const BakedLut& baked) {
    LutHeader header;
    header.software = "nacre " + std::string(nacre_version());
    header.interop_id = space.interop_id();
    header.chromaticities = chromaticities_of(space);
    Attributes& attributes = header.nacre;
    attributes.emplace_back("version", std::string(nacre_version()));
    add_job(attributes, chosen.lut);
    add_light(attributes, chosen.lut.job);
    add_accuracy(attributes, chosen, baked);
    add_colour(attributes, chosen.lut.colour.gamut, source, space, baked);
    if (!chosen.lut.edits.empty()) attributes.emplace_back("edits", comma_separated(chosen.lut.edits));
    const std::string scene = scene_toml(chosen.lut);
    attributes.emplace_back("scene", scene);
    attributes.emplace_back("sceneHash", hash_text(scene));
    return header;
}

}  // namespace nacre
