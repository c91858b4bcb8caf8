#include "web/session_json.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "io/scene/toml_places.h"
#include "nacre/base/error.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/rgb_colour_space.h"
#include "nacre/material/effects.h"
#include "nacre/optics/palette.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/shade/palette_colour.h"
#include "web/plain_exr.h"

namespace nacre {
namespace {

const RgbColourSpace& rec709() {
    static const RgbColourSpace space(known_rgb_spaces().front());
    return space;
}

Json value_json(const TomlPlace& place) {
    Json json{{"place", Json{{"line", place.line},
                             {"column", place.column},
                             {"endLine", place.end_line},
                             {"endColumn", place.end_column}}}};
    if (const auto* truth = std::get_if<bool>(&place.value)) json["value"] = *truth;
    if (const auto* number = std::get_if<double>(&place.value)) json["value"] = *number;
    if (const auto* text = std::get_if<std::string>(&place.value)) json["value"] = *text;
    return json;
}

// "scene.toml:12:5 [material.a]: ..." has its place in front; other lines have none.
Json mistake_json(std::string_view line) {
    int numbers[2] = {0, 0};
    std::size_t at = line.find(':');
    for (int& number : numbers) {
        if (at == std::string_view::npos || at + 1 >= line.size()) break;
        std::size_t end = at + 1;
        while (end < line.size() && line[end] >= '0' && line[end] <= '9') ++end;
        if (end == at + 1) break;
        number = std::stoi(std::string(line.substr(at + 1, std::min<std::size_t>(end - at - 1, 9))));
        at = end < line.size() && line[end] == ':' ? end : std::string_view::npos;
    }
    return {{"message", line}, {"line", numbers[0]}, {"column", numbers[1]}};
}

Json lobe_json(const Lobe& lobe) {
    return {{"peakNm", lobe.peak_nm},
            {"widthNm", lobe.width_nm},
            {"height", lobe.height},
            {"floor", lobe.floor},
            {"flatness", lobe.flatness}};
}

Json rgb_json(const Rgb& rgb) {
    return Json::array({rgb.r, rgb.g, rgb.b});
}

Json pick_json(const SceneMaterial& material, const Palette& palette, std::size_t pick, const Light& light) {
    Json json = lobe_json(palette.picks[pick].lobe);
    json["angleDeg"] = palette.picks[pick].angle_deg;
    json["rgb"] = rgb_json(in_rec709(adapt(light.adaptation, lobe_to_xyz(light, palette.picks[pick].lobe))));
    for (const PickedColour& picked : material.picked) {
        if (picked.pick != pick) continue;
        json["colour"] = picked.text;
        json["de00"] = picked.de00;
        json["note"] = match_text(picked);
    }
    return json;
}

Json axis_json_of(const Axis& axis) {
    if (!axis.is_angle())
        return {{"name", axis.parameter.name}, {"isAngle", false}, {"from", axis.from}, {"to", axis.to}};
    return {{"name", axis.kind->name}, {"isAngle", true}, {"from", axis.from}, {"to", axis.to}};
}

Json effect_json(const EffectChoice& choice) {
    return {{"name", row_of(choice.effect).name},
            {"isSimulated", choice.is_simulated},
            {"isGiven", choice.is_given},
            {"contribution", choice.contribution},
            {"share", choice.share}};
}

Json matrix_json(const ColourSpace& space) {
    // Rows, as they are applied: the texels' space to XYZ to linear Rec.709.
    const glm::dmat3 matrix = *rec709().linear_matrix() * glm::inverse(*space.linear_matrix());
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) rows.push_back(matrix[column][row]);
    }
    return rows;
}

}  // namespace

Rgb in_rec709(const Xyz& colour) {
    return rec709().to_rgb(colour);
}

Json values_json(const std::string& text) {
    Json values = Json::object();
    try {
        for (const TomlPlace& place : toml_places(text, "scene.toml")) values[place.path] = value_json(place);
    } catch (const Error&) {
        // Whoever plans the scene says why it is not TOML.
    }
    return values;
}

Json mistakes_json(const std::string& message) {
    Json mistakes = Json::array();
    for (std::size_t begin = 0; begin <= message.size();) {
        const std::size_t end = std::min(message.find('\n', begin), message.size());
        mistakes.push_back(mistake_json(std::string_view(message).substr(begin, end - begin)));
        begin = end + 1;
    }
    return mistakes;
}

Json material_json(const SceneMaterial& material, const Light& light) {
    Json json{{"name", material.name}, {"mechanism", mechanism_name(material.mechanism)}};
    const auto* palette = std::get_if<Palette>(&material.mechanism);
    if (palette == nullptr) return json;
    json["shape"] = palette->shape;
    json["picks"] = Json::array();
    for (std::size_t i = 0; i < palette->picks.size(); ++i)
        json["picks"].push_back(pick_json(material, *palette, i, light));
    json["curve"] = Json::array();
    const PaletteCurve curve(*palette);
    for (int angle_deg = 0; angle_deg <= 90; ++angle_deg)
        json["curve"].push_back(lobe_json(curve.at(Incidence::from_degrees(angle_deg))));
    return json;
}

Json lut_summary_json(const PlannedLut& lut) {
    const bool is_transmitted = is_transmittance(lut.job.material.mechanism);
    Json json{{"name", lut.name},
              {"material", lut.job.material.name},
              {"quantity", is_transmitted ? "transmittance" : "reflectance"},
              {"entry", lut.entry},
              {"x", axis_json_of(lut.job.x)},
              {"maxDe00", lut.request.max_de00}};
    if (lut.job.y) json["y"] = axis_json_of(*lut.job.y);
    return json;
}

Json seconds_json(const DecidedLut& decided, const BakedLut& baked) {
    return {
        {"deciding", decided.seconds}, {"computing", baked.computing_seconds}, {"measuring", baked.measuring_seconds}};
}

std::size_t exr_bytes(const DecidedLut& decided, const BakedLut& baked) {
    return plain_exr(baked.image, decided.lut.lut.format, baked.header).size();
}

Json baked_json(const DecidedLut& decided, const BakedLut& baked) {
    const PlannedLut& lut = decided.lut.lut;
    Json json = lut_summary_json(lut);
    json["width"] = baked.image.width();
    json["height"] = baked.image.height();
    json["format"] = name_of(format_words, lut.format);
    json["space"] = decided.space().name();
    json["toRec709"] = matrix_json(decided.space());
    if (baked.reached) json["reached"] = *baked.reached;
    json["bytes"] = exr_bytes(decided, baked);
    json["seconds"] = seconds_json(decided, baked);
    json["effects"] = Json::array();
    for (const EffectChoice& choice : decided.lut.effects) json["effects"].push_back(effect_json(choice));
    if (baked.clamped.below_deg) json["clampedBelowDeg"] = *baked.clamped.below_deg;
    if (baked.clamped.above_deg) json["clampedAboveDeg"] = *baked.clamped.above_deg;
    json["warnings"] = Json::array();
    if (decided.is_out_of_reach()) json["warnings"].push_back(out_of_reach(decided.lut));
    return json;
}

}  // namespace nacre
