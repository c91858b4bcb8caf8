#include "pipeline/verify_lut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/disk/hash.h"
#include "io/scene/scene_file.h"
#include "io/scene/shipped_materials.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/planned_lut.h"
#include "pipeline/baked_lut.h"

namespace nacre {
namespace {

constexpr std::size_t longest_scene = 16u << 20;

// Every attribute that a header must have; the rest depends on the LUT.
constexpr std::array required_attributes{"version",          "scene",           "sceneHash",   "lut",
                                         "material",         "mechanism",       "axisX",       "size",
                                         "sampling",         "illuminant",      "observer",    "adapt",
                                         "rangeNm",          "integration",     "colourSpace", "colourConfig",
                                         "colourConfigHash", "colourTransform", "gamut",       "format",
                                         "accuracyAsked",    "accuracyReached"};

// What only says where the transform came from, or which program wrote it.
bool is_about_origin(const std::string& name) {
    // What was measured about effects when they were chosen, the colours that picks were given as, and what was changed
    // in the scene: the scene in the header has the choice itself, the bands that the colours became, and the result.
    return name == "version" || name == "colourConfig" || name == "colourConfigHash" || name == "effects" ||
           name == "picked" || name == "edits";
}

Plan plan_of_header(const StoredLut& stored) {
    if (!stored.breach.empty()) throw Error(stored.breach);
    const std::string scene = stored.header.value("scene");
    if (scene.empty() || stored.header.value("colourTransform").empty()) {
        throw Error("the header does not say how the LUT was made");
    }
    if (scene.size() > longest_scene) throw Error("the scene in the header is longer than 16 MB");
    if (hash_text(scene) != stored.header.value("sceneHash")) {
        throw Error("the scene in the header is not the one that its hash was made of");
    }
    const auto refuse_file = [](const std::string& file, const Where& where, const CsvKeys&) -> SampledCurve {
        throw Error(where.text() + ": names the file " + file);
    };
    const auto refuse_spectra = [](const std::string& file, const Where& where, const CsvKeys&) -> MeasuredSpectra {
        throw Error(where.text() + ": names the file " + file);
    };
    const auto find_shipped = [](const std::string& name, const Where& where) {
        auto material = shipped_material(name);
        if (!material) throw Error(where.text() + ": names the material " + in_quotes(name));
        return material;
    };
    Plan plan = plan_scene(parse_scene(scene, "header"), {refuse_file, find_shipped, refuse_spectra});
    if (plan.luts.size() != 1 || !plan.swatches.empty()) throw Error("the scene in the header holds more than one LUT");
    const PlannedLut& lut = plan.luts.front();
    const int height = lut.job.y ? lut.request.height.value_or(0) : 1;
    if (lut.request.width != stored.image.width() || height != stored.image.height()) {
        throw Error("the scene in the header makes another size");
    }
    if (lut.request.format != stored.format) throw Error("the scene in the header asks for another number format");
    return plan;
}

void compare_headers(const LutHeader& stored, const LutHeader& derived, Verification& result) {
    for (const auto& [name, value] : derived.nacre) {
        if (!is_about_origin(name) && stored.value(name) != value) result.wrong.push_back("nacre:" + name);
    }
    for (const auto& [name, value] : stored.nacre) {
        if (derived.value(name).empty() && !is_about_origin(name)) result.wrong.push_back("nacre:" + name);
    }
    if (stored.interop_id != derived.interop_id) result.wrong.emplace_back("colorInteropID");
    if (stored.chromaticities != derived.chromaticities) result.wrong.emplace_back("chromaticities");
}

void compare_texels(const StoredLut& stored, const Image<Rgb>& derived, Verification& result) {
    for (std::size_t i = 0; i < stored.image.size(); ++i) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            const double difference = std::abs(derived.data()[i].*component - stored.image.data()[i].*component);
            if (difference == 0.0) continue;
            ++result.differing;  // NaN differs too
            result.largest_difference =
                std::isnan(difference) ? difference : std::max(result.largest_difference, difference);
        }
    }
}

}  // namespace

Verification verify_lut(const StoredLut& stored, const ReadColourSpace& read_space, const AfterRow& after_row) {
    Verification result;
    for (const char* name : required_attributes) {
        if (stored.header.value(name).empty()) result.missing.emplace_back(name);
    }
    try {
        const Plan plan = plan_of_header(stored);
        const auto space =
            read_space(stored.header.value("colourTransform"), plan.colour.space, "header", stored.header.interop_id);
        const Encoding encoding = lut_encoding(*space, plan.colour.gamut);
        const ChosenLut chosen = choose_lut(plan.luts.front(), encoding, after_row);
        const BakedLut again = bake_lut(chosen, plan, {}, *space, after_row);
        compare_headers(stored.header, again.header, result);
        compare_texels(stored, again.image, result);
        result.error = again.reached;
        if (encoding.to_xyz && result.differing > 0) {
            // In this order what is not a number stays so.
            result.error =
                std::max(measure(chosen.lut.job, stored.image, encoding, chosen.worst).reached, *result.error);
        }
    } catch (const IoError&) {
        throw;  // the system's refusal says nothing about the LUT
    } catch (const Error& error) {
        result.problem = error.what();
    }
    return result;
}

}  // namespace nacre
