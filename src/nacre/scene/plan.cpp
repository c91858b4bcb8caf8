// How a scene becomes a plan.
//
// 1. Read what everything else refers to: the format's version, [accuracy], [light], [colour]. They depend on nothing
//    but each other: [light] takes `wavelengths` from [accuracy], and its white is checked with them.
// 2. Resolve names. LUTs and swatches name materials, and swatches name LUTs. Materials are read when they are asked
//    for first, so that a request for one LUT reads one material and its files. Picks are resolved here, too: a picked
//    colour becomes a band, or a search for a film, stack, grating or crystal. The search needs the light, so it comes
//    after step 1.
// 3. Check what only the whole plan can say: keys that nobody read, files that two outputs would write, and picks that
//    were missed.
//
// Each step returns its part (plan_tables.h); nothing is changed after it was returned.
#include "nacre/scene/plan.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/pick_reader.h"
#include "nacre/shade/measured_colour.h"

namespace nacre {
namespace {

constexpr Allowed allowed_version{1, 1};

// Finds the band of a colour. The finder's tables take some milliseconds, so they wait for the first colour.
LobeReader lobe_reader(const std::shared_ptr<const Light>& light, const LeastSquaresSolver& solver) {
    auto finder = std::make_shared<std::optional<LobeFinder>>();
    return [finder, light, solver](const Xyz& colour) {
        if (!*finder) finder->emplace(light->weights, light->moments, light->adaptation, solver);
        return (*finder)->find(colour);
    };
}

PickReaders pick_readers(const SceneFiles& files, const std::shared_ptr<const Light>& light,
                         const ColourSettings& settings) {
    return {[&files, settings](const Rgb& colour, const std::string& space, const Where& where) {
                if (!files.read_colour)
                    throw Error(where.text() + ": a colour needs an OpenColorIO config, and there is none here");
                return files.read_colour(colour, space, where, settings);
            },
            lobe_reader(light, files.least_squares),
            [light](const Lobe& lobe) {
                return adapt(light->adaptation, lobe_to_xyz(light->weights, lobe.peak_nm, lobe.width_nm, lobe.height));
            },
            [light](const MeasuredSpectra& spectra, double angle_deg) {
                return adapt(light->adaptation, MeasuredColour(spectra, *light).at(Incidence::from_degrees(angle_deg)));
            }};
}

// @param files  has to outlive what is returned
SceneContext material_context(const SceneFiles& files, const std::shared_ptr<const Light>& light,
                              const ColourSettings& colour) {
    const LightSettings& settings = light->settings;
    SceneContext context{
        {files.find_material, static_cast<double>(settings.first_nm), static_cast<double>(settings.last_nm)},
        files.read_curve,
        files.read_spectra,
        pick_readers(files, light, colour)};
    if (files.find_mechanisms) {
        context.find_mechanisms = [&files, light](const MechanismSearch& search) {
            return files.find_mechanisms(search, *light);
        };
    }
    return context;
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
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
    scene.integer_or("nacre", allowed_version, 1);
    const AccuracySettings accuracy = read_accuracy(scene.table("accuracy"));
    const std::shared_ptr<const Light> light = plan_light(scene, accuracy, files.read_curve);
    const ColourSettings colour = plan_colour(scene);

    Materials materials(scene, material_context(files, light, colour), light->settings);
    const SceneParts parts{scene, accuracy, light, materials};
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
              std::move(swatches.swatches)};
    if (request.strict) {
        const std::vector<std::string> messages = missed_pick_messages(plan, true);
        if (!messages.empty()) throw Error(messages.front());
    }
    plan.warnings = joined(accuracy.warnings, warnings_of(plan));
    scene.expect_all_read();
    OutputNames().claim(plan);
    return plan;
}

}  // namespace nacre
