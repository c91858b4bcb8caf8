// How a scene becomes a plan.
//
// 1. Read what everything else refers to: the format's version, [accuracy], [light], [colour]. They depend on nothing
//    but each other: [light] takes `wavelengths` from [accuracy], and its white is checked with them.
// 2. Resolve names. LUTs and swatches name materials, and swatches name LUTs. Materials are read when they are asked
//    for first, so that a request for one LUT reads one material and its files. Picks are resolved here, too: a picked
//    colour becomes a band, or a search for a film, stack, grating or crystal. The search needs the light, so it comes
//    after step 1.
// 3. Check what only the whole plan can say: keys that nobody read, files that two outputs would write, and picks that
//    were unmatched.
//
// Each step returns its part (plan_tables.h); nothing is changed after it was returned. Mistakes are noted in the
// scene's tables, reading goes on, and at the end throw_mistakes() reports them all. What a mistake leaves unknown is
// not computed with: colours and searches wait for a scene without mistakes.
#include "nacre/scene/plan.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/mistakes.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/pick_reader.h"
#include "nacre/shade/measured_colour.h"
#include "nacre/shade/palette_colour.h"

namespace nacre {
namespace {

// `nacre = 1`. It becomes 2 when scenes of 1 would mean something else.
constexpr int format_version = 1;

// Throws for a scene of a newer version at once: its other mistakes are none.
void check_version(const Table& scene) {
    const Value* value = scene.find("nacre");
    if (value == nullptr) return;
    const auto* version = std::get_if<std::int64_t>(&value->data);
    if (version != nullptr && *version > format_version) {
        scene.fail(value->where, "nacre = " + value->text() +
                                     " means that the scene is made for a newer nacre; this program reads nacre = " +
                                     std::to_string(format_version));
    }
    scene.checked_integer("nacre", *value, {1, format_version});
}

// Finds bands. The tables for it wait for the first colour.
BandReader band_reader(const std::shared_ptr<const Light>& light, const std::shared_ptr<KnownBands>& known) {
    return {[known, light](const Xyz& colour) { return shown_colour(known->under(light), *light, colour); },
            [known, light](const std::vector<ColourOrBand>& picks) {
                return palette_bands(known->under(light), *light, picks);
            }};
}

ColourReader colour_reader(const SceneFiles& files, const ColourSettings& settings) {
    return [&files, settings](const Rgb& colour, const std::string& space, const Where& where) {
        if (!files.read_colour)
            throw Error(where.text() + ": a colour needs an OpenColorIO config, and there is none here");
        return files.read_colour(colour, space, where, settings);
    };
}

PickReaders pick_readers(const SceneFiles& files, const std::shared_ptr<const Light>& light,
                         const ColourSettings& settings, const std::shared_ptr<KnownBands>& known) {
    // Under an unknown light a colour can be read, but no band be found for it.
    if (light == nullptr) {
        return {colour_reader(files, settings),
                {[](const Xyz& colour) { return ShownColour{colour}; },
                 [](const std::vector<ColourOrBand>& picks) {
                     return std::vector<Lobe>(picks.size(), {550.0, 100.0, 0.5});
                 }},
                [](const Lobe&) { return Xyz{}; },
                [](const MeasuredSpectra&, double) { return Xyz{}; }};
    }
    return {colour_reader(files, settings), band_reader(light, known),
            [light](const Lobe& lobe) { return adapt(light->adaptation, lobe_to_xyz(*light, lobe)); },
            [light](const MeasuredSpectra& spectra, double angle_deg) {
                return adapt(light->adaptation, MeasuredColour(spectra, *light).at(Incidence::from_degrees(angle_deg)));
            }};
}

// The answer of a search that is not worth its time, because the scene has mistakes.
std::vector<FoundMechanism> not_searched(const MechanismSearch& search) {
    FoundMechanism found;
    found.mechanism = search.start;
    found.reached.resize(search.wanted.size());
    found.de00.resize(search.wanted.size());
    return {found};
}

// @param scene,files  have to outlive what is returned
SceneContext material_context(const Table& scene, const SceneFiles& files, const std::shared_ptr<const Light>& light,
                              const ColourSettings& colour, const std::shared_ptr<KnownBands>& known) {
    // A material is known over all of an unknown light.
    constexpr double some_nm = 550.0;
    const double first_nm = light == nullptr ? some_nm : light->settings.first_nm;
    const double last_nm = light == nullptr ? some_nm : light->settings.last_nm;
    SceneContext context{{files.find_material, first_nm, last_nm},
                         files.read_curve,
                         files.read_spectra,
                         pick_readers(files, light, colour, known)};
    if (files.find_mechanisms) {
        context.find_mechanisms = [&scene, &files, light](const MechanismSearch& search) {
            return scene.is_good() ? files.find_mechanisms(search, *light) : not_searched(search);
        };
    }
    return context;
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// What only the whole plan can say.
void check_plan(const Table& scene, const Plan& plan, const PlanRequest& request) {
    scene.expect_all_read();
    attempt(scene, scene.where(), [&] { OutputNames().claim(plan); });
    if (!request.strict || !scene.is_good()) return;
    for (const Mistake& unmatched : unmatched_pick_mistakes(plan, true))
        scene.note(SceneError(unmatched.where, unmatched.text), unmatched.where);
}

}  // namespace

const SceneMaterial* find_material(const Plan& plan, const std::string& name) {
    const auto found = std::find_if(plan.materials.begin(), plan.materials.end(),
                                    [&](const SceneMaterial& material) { return material.name == name; });
    return found == plan.materials.end() ? nullptr : &*found;
}

bool PlanRequest::wants(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

Plan plan_scene(const Table& scene, const SceneFiles& files, const PlanRequest& request) {
    check_version(scene);
    scene.skip("variants");  // each of them is a scene of its own
    AccuracySettings accuracy;
    attempt(scene, scene.where(), [&] { accuracy = read_accuracy(scene.table("accuracy")); });
    const std::shared_ptr<const Light> light = plan_light(scene, accuracy, files.read_curve);
    const ColourSettings colour = plan_colour(scene);

    const auto bands = request.bands ? request.bands : std::make_shared<KnownBands>();
    SceneContext context = material_context(scene, files, light, colour, bands);
    context.picks.wants_pale_paths = request.wants_pale_paths;
    Materials materials(scene, std::move(context), light, request.any_thickness);
    const SceneParts parts{scene, accuracy, colour, light, materials, request.any_thickness};
    PlannedLuts luts = plan_luts(parts, request);
    PlannedSwatches swatches = plan_swatches(parts, request, luts.names);
    if (request.all_materials) {
        for (const std::string& name : materials.names()) materials.named(name);
    }

    Plan plan{light,
              colour,
              joined(luts.names, swatches.names),
              {},
              materials.read(),
              materials.searches(),
              std::move(luts.luts),
              std::move(swatches.swatches),
              !swatches.names.empty()};
    check_plan(scene, plan, request);
    throw_mistakes(scene);
    plan.warnings = joined(joined(accuracy.warnings, noted_warnings(scene)), warnings_of(plan));
    return plan;
}

}  // namespace nacre
