#include "pipeline/manifest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/words.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/gamut.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/rounding.h"
#include "pipeline/version.h"

namespace nacre {
namespace {

// What the texels are, and where they lie.
void add_texture(Json& json, const PlannedLut& lut) {
    const Job& job = lut.job;
    json["lut"] = lut.name;
    if (std::find(lut.outputs.begin(), lut.outputs.end(), LutOutput::exr) != lut.outputs.end())
        json["file"] = lut.name + ".exr";
    json["material"] = job.material.name;
    json["mechanism"] = mechanism_name(job.material.mechanism);
    if (is_transmittance(job.material.mechanism)) json["quantity"] = "transmittance";
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
}

void add_colour(Json& json, const BakedLut& baked) {
    const LutHeader& header = baked.header;
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
                     {"most_negative", -rounded_up(-baked.gamut.most_negative)}};
    // Of what is kept it would say the same again.
    if (header.value("gamut") != name_of(gamut_words, Gamut::keep))
        json["gamut"]["left"] = {{"texels_outside", baked.left.outside},
                                 {"most_negative", -rounded_up(-baked.left.most_negative)}};
}

void add_light(Json& json, const LightSettings& light, const LutHeader& header) {
    json["light"] = {{"illuminant", light.illuminant},
                     {"observer", header.value("observer")},
                     {"adapt", header.value("adapt")},
                     {"range_nm", Json::array({light.first_nm, light.last_nm})},
                     {"integration", header.value("integration")}};
}

void add_accuracy(Json& json, const ChosenLut& chosen, const BakedLut& baked) {
    const AccuracyRequest& request = chosen.lut.request;
    Json& accuracy = json["accuracy"];
    accuracy["max_de00"] = request.has_bound ? Json(request.max_de00) : Json();
    accuracy["predicted"] = baked.reached ? Json(rounded_up(chosen.predicted.total)) : Json();
    accuracy["reached"] = baked.reached ? Json(*baked.reached) : Json();
    if (baked.measured)
        accuracy["points"] = {{"model", baked.measured->model_points}, {"reference", baked.measured->reference_points}};
    for (const EffectChoice& choice : chosen.effects) {
        Json effect{{"effect", row_of(choice.effect).name},
                    {"state", choice.is_simulated ? "simulated"
                              : choice.is_given   ? "left out"
                                                  : "negligible"}};
        if (!choice.is_simulated) effect["de00"] = rounded_up(choice.contribution);
        if (!choice.is_simulated && !choice.is_given) effect["share"] = choice.share;
        json["effects"].push_back(effect);
    }
}

}  // namespace

Json axis_json(const Axis& axis) {
    if (axis.is_angle()) return {{"axis", axis.kind->name}};
    return {{"parameter", axis.parameter.name}, {"from", axis.from}, {"to", axis.to}};
}

Json shift_json(const ColourShift& shift) {
    return {{"mean_de00", rounded_up(shift.mean)}, {"percentile_95_de00", rounded_up(shift.percentile_95)}};
}

Json picked_json(const PickedColour& picked) {
    Json json{{"pick", picked.pick}, {"angle_deg", picked.angle_deg}, {"colour", picked.text}};
    if (picked.lobe) {
        json["peak_nm"] = picked.lobe->peak_nm;
        json["width_nm"] = picked.lobe->width_nm;
        json["height"] = picked.lobe->height;
        json["floor"] = picked.lobe->floor;
        json["flatness"] = picked.lobe->flatness;
        json["shown_luminance"] = std::round(picked.shown.luminance * 1e6) / 1e6;
        json["shown_chroma"] = std::round(picked.shown.chroma * 1e6) / 1e6;
    }
    json["de00"] = rounded_up(picked.de00);
    json["match"] = picked.is_met() ? (picked.lobe ? "exact" : "met") : (picked.lobe ? "dimmed" : "unmatched");
    if (picked.tolerance) json["tolerance"] = shift_json(*picked.tolerance);
    return json;
}

Json manifest_json(const ChosenLut& chosen, const BakedLut& baked) {
    Json json{{"nacre", nacre_version()}};
    add_texture(json, chosen.lut);
    add_colour(json, baked);
    add_light(json, chosen.lut.job.light->settings, baked.header);
    add_accuracy(json, chosen, baked);
    for (const PickedColour& picked : baked.picked) json["picked"].push_back(picked_json(picked));
    if (baked.clamped.below_deg) json["clamped_below_deg"] = rounded_angle(*baked.clamped.below_deg);
    if (baked.clamped.above_deg) json["clamped_above_deg"] = rounded_angle(*baked.clamped.above_deg);
    if (!chosen.lut.edits.empty()) json["edits"] = chosen.lut.edits;
    json["scene"] = baked.header.value("scene");
    json["scene_hash"] = baked.header.value("sceneHash");
    return json;
}

std::string manifest_text(const ChosenLut& chosen, const BakedLut& baked) {
    return manifest_json(chosen, baked).text() + "\n";
}

}  // namespace nacre
