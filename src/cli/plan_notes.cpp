#include "cli/plan_notes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/found_report.h"
#include "cli/report.h"
#include "nacre/base/text.h"
#include "nacre/base/words.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/band/pale_path.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

std::string rgb_text(const std::array<double, 3>& rgb) {
    return "(" + number_text(rgb[0]) + ", " + number_text(rgb[1]) + ", " + number_text(rgb[2]) + ")";
}

// A material as it is called in the variant that the scene is of.
std::string called(const std::string& material, const LoadedScene& scene) {
    return scene.plan.variant.empty() ? material : scene.plan.variant + ": " + material;
}

// What picked colours became.
void note_picked(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        for (const PickedColour& picked : material.picked) {
            std::string band;
            if (picked.lobe) {
                band = " is the band peak_nm = " + significant_text(picked.lobe->peak_nm, 6) +
                       ", width_nm = " + significant_text(picked.lobe->width_nm, 6) +
                       ", height = " + significant_text(picked.lobe->height, 4);
                if (picked.lobe->floor != 0.0) band += ", floor = " + significant_text(picked.lobe->floor, 4);
                if (picked.lobe->flatness != 0.0) band += ", flatness = " + significant_text(picked.lobe->flatness, 4);
                band += ",";
            }
            console.summary(called(material.name, scene) + ": " + picked.text + " at " + number_text(picked.angle_deg) +
                            " deg" + band + (picked.lobe ? " " : ": ") + match_text(picked));
        }
    }
    for (const MaterialSearch& search : scene.plan.searches) {
        if (search.search.free.empty()) continue;
        for (std::size_t i = 0; i < search.found.size(); ++i)
            console.summary(called(search.material, scene) + ": " + (i == 0 ? "found " : "or    ") +
                            answer_text(search, i));
    }
}

// What the picks say about the shape that the scene left open.
void note_shapes(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        if (!material.shape_fit) continue;
        const auto& picks = std::get<Palette>(material.mechanism).picks;
        std::string misses;
        for (std::size_t i = 0; i < picks.size(); ++i) {
            misses += (i == 0 ? "" : ", ") + significant_text(material.shape_fit->de00[i], 2) + " at " +
                      number_text(picks[i].angle_deg) + " deg";
        }
        console.summary(called(material.name, scene) + ": shape = " + number_text(material.shape_fit->shape) +
                        " fits its picks best; straight lines would miss them by CIEDE2000 " + misses);
    }
}

// Where the way from one colour to the next is greyer than both.
void note_pale_paths(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        const auto* palette = std::get_if<Palette>(&material.mechanism);
        for (const PalePath& path : material.pale_paths)
            console.summary(called(material.name, scene) + ": " + pale_path_text(path, *palette) +
                            (path.middle_helps ? "" : "; nacre pick looks for a film or a stack that does"));
    }
}

// What a scene's picks ask for that no surface can do.
void note_clamps(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        const auto* palette = std::get_if<Palette>(&material.mechanism);
        if (palette == nullptr) continue;
        const ClampBounds bounds = palette_clamp_bounds(*palette);
        const auto note = [&](const char* side, const std::optional<double>& angle_deg) {
            if (!angle_deg) return;
            console.summary(called(material.name, scene) + ": clamped " + side + " " + short_number(*angle_deg) +
                            " deg, where its picks lead to a number outside its range");
        };
        note("below", bounds.below_deg);
        note("above", bounds.above_deg);
    }
}

// What measurements do not say, and how it is filled in.
void note_edges(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        const auto* spectra = std::get_if<MeasuredSpectra>(&material.mechanism);
        if (spectra == nullptr) continue;
        const auto range = [](double first, double last) { return number_text(first) + " to " + number_text(last); };
        console.summary(called(material.name, scene) + ": measured from " +
                        range(spectra->wavelength_nm.front(), spectra->wavelength_nm.back()) + " nm and " +
                        range(spectra->angle_deg.front(), spectra->angle_deg.back()) +
                        " deg; outside, the nearest measurement is held");
    }
}

// How metals of a colour are made.
void note_metals(const LoadedScene& scene, Console& console) {
    for (const SceneMaterial& material : scene.plan.materials) {
        for_each_index(material.mechanism, [&](const Index& index, IndexRole) {
            if (index.is_constant() || !index.curve->metal) return;
            const auto range = [](const std::vector<double>& values) {
                const auto [least, most] = std::minmax_element(values.begin(), values.end());
                const std::string first = significant_text(*least, 3), last = significant_text(*most, 3);
                return first == last ? first : first + " to " + last;
            };
            const auto* n = std::get_if<SampledCurve>(&index.curve->n);
            console.summary(called(material.name, scene) + ": the metal with F0 = " + rgb_text(index.curve->metal->f0) +
                            " has n = " + (n != nullptr ? range(n->value) : "1") +
                            ", k = " + range(std::get<SampledCurve>(index.curve->k).value) +
                            ": a smooth reflectance of this colour under D65");
        });
    }
}

}  // namespace

void note_scene(const LoadedScene& scene, Console& console) {
    note_picked(scene, console);
    note_shapes(scene, console);
    note_pale_paths(scene, console);
    note_clamps(scene, console);
    note_edges(scene, console);
    note_metals(scene, console);
    for (const PlannedLut& lut : scene.plan.luts) {
        if (lut.preview != Preview::none) console.summary(preview_file(lut) + ": preview");
    }
    for (const PlannedSwatch& swatch : scene.plan.swatches)
        console.summary(swatch.name + ".png: " + std::string(name_of(swatch_words, swatch.kind)));
}

}  // namespace nacre
