#include "web/session.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/lut/bake.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/palette_colour.h"
#include "pipeline/bake_within_bound.h"
#include "pipeline/manifest.h"
#include "pipeline/pick_answer.h"
#include "pipeline/pick_scene.h"
#include "web/page_spaces.h"
#include "web/plain_exr.h"
#include "web/session_json.h"

namespace nacre {
namespace {

// What messages call the text in the page.
constexpr const char* scene_name = "scene.toml";
// Chosen: an eighth of the texels and of the time, and an error that a glance does not see.
constexpr double coarse_times = 8.0;

SceneRequest page_request() {
    SceneRequest request;
    request.open_colours = page_spaces;
    request.want_swatches = false;
    return request;
}

// A LUT and, if it is one of a pair, the other.
std::vector<DecidedLut> decided_with_its_pair(const LoadedScene& scene, const PlannedLut& lut) {
    std::vector<DecidedLut> luts;
    for (const PlannedLut& one : scene.plan.luts) {
        if (&one != &lut && !(lut.is_of_pair && one.is_of_pair && one.entry == lut.entry)) continue;
        DecidedLut& next = luts.emplace_back();
        next.scene = &scene;
        next.asked = &one;
    }
    decide_all(luts, {});
    return luts;
}

std::vector<float> components(const Image<Rgb>& image) {
    std::vector<float> numbers;
    numbers.reserve(image.size() * 3);
    for (const Rgb& texel : image) {
        for (const double component : {texel.r, texel.g, texel.b}) numbers.push_back(static_cast<float>(component));
    }
    return numbers;
}

// The LUT with another bound, which is a goal: the best there is if it cannot be met.
PlannedLut with_bound(const PlannedLut& lut, double max_de00) {
    PlannedLut other = lut;
    other.request.max_de00 = std::clamp(max_de00, allowed_max_de00.low, allowed_max_de00.high);
    other.request.has_bound = true;
    other.request.is_binding = false;
    other.is_of_pair = false;
    return other;
}

DecidedLut decided_alone(const LoadedScene& scene, const PlannedLut& lut) {
    std::vector<DecidedLut> luts(1);
    luts.front().scene = &scene;
    luts.front().asked = &lut;
    decide_all(luts, {});
    if (!luts.front().failure.empty()) throw Error(luts.front().failure);
    return std::move(luts.front());
}

// A pick as a scene has it: as a colour if it was one, else as its band.
PickLine pick_line(const SceneMaterial& material, const Palette& palette, std::size_t pick) {
    const std::string angle = "{ angle_deg = " + number_text(palette.picks[pick].angle_deg);
    for (const PickedColour& picked : material.picked) {
        const bool is_hex = picked.pick == pick && picked.text.starts_with('#');
        if (is_hex) return {angle + ", colour = " + toml_string(picked.text) + " }", ""};
    }
    const Lobe& lobe = palette.picks[pick].lobe;
    return {angle + ", peak_nm = " + number_text(lobe.peak_nm) + ", width_nm = " + number_text(lobe.width_nm) +
                ", height = " + number_text(lobe.height) + ", floor = " + number_text(lobe.floor) +
                ", flatness = " + number_text(lobe.flatness) + " }",
            ""};
}

}  // namespace

const LoadedScene& Session::scene() const {
    if (scenes_.empty()) throw Error("no scene is open; open one that has no mistakes");
    return scenes_.front();
}

const PlannedLut& Session::planned(const std::string& lut) const {
    for (const PlannedLut& one : scene().plan.luts) {
        if (one.name == lut) return one;
    }
    throw Error("the scene has no LUT " + in_quotes(lut));
}

std::vector<std::string> Session::luts() const {
    std::vector<std::string> names;
    for (const PlannedLut& one : scene().plan.luts) names.push_back(one.name);
    return names;
}

Json Session::open(const std::string& text) {
    Json json{{"mistakes", Json::array()},
              {"warnings", Json::array()},
              {"values", values_json(text)},
              {"materials", Json::array()},
              {"luts", Json::array()}};
    SceneRequest request = page_request();
    request.all_materials = true;
    request.on_warning = [&](const std::string& warning) { json["warnings"].push_back(warning); };
    std::vector<LoadedScene> opened;
    try {
        opened.push_back(load_scene_text(text, scene_name, request));
    } catch (const Error& error) {
        json["mistakes"] = mistakes_json(error.what());
        return json;
    }
    if (text != text_ || files_changed_) {
        entries_.clear();
        scenes_ = std::move(opened);
        text_ = text;
        files_changed_ = false;
    }
    const Plan& plan = scene().plan;
    for (const SceneMaterial& material : plan.materials)
        json["materials"].push_back(material_json(material, *plan.light));
    for (const PlannedLut& lut : plan.luts) json["luts"].push_back(lut_summary_json(lut));
    return json;
}

Session::Entry& Session::baked(const std::string& lut) {
    const auto find = [&] {
        return std::find_if(entries_.begin(), entries_.end(),
                            [&](const Entry& e) { return e.decided.asked->name == lut; });
    };
    if (find() == entries_.end()) {
        for (DecidedLut& one : decided_with_its_pair(scene(), planned(lut)))
            entries_.push_back({std::move(one), nullptr});
    }
    Entry& entry = *find();
    if (!entry.decided.failure.empty()) throw Error(entry.decided.failure);
    if (entry.decided.is_out_of_reach() && entry.decided.lut.lut.request.is_binding)
        throw Error(out_of_reach(entry.decided.lut));
    if (!entry.baked) entry.baked = std::make_unique<BakedLut>(bake_within_bound(entry.decided, {}));
    return entry;
}

Session::Answer Session::bake(const std::string& lut, bool is_coarse) {
    if (!is_coarse) {
        const Entry& entry = baked(lut);
        return {baked_json(entry.decided, *entry.baked), components(entry.baked->image)};
    }
    const PlannedLut& asked = planned(lut);
    const PlannedLut wide = with_bound(asked, asked.request.max_de00 * coarse_times);
    const DecidedLut decided = decided_alone(scene(), wide);
    if (decided.is_out_of_reach() && asked.request.is_binding) throw Error(out_of_reach(decided.lut));
    BakedLut baked;
    baked.image = decided.space().to_rgb(nacre::bake(decided.lut.lut.job));
    return {baked_json(decided, baked), components(baked.image)};
}

Json Session::cost(const std::string& lut, double max_de00) {
    const PlannedLut bound = with_bound(planned(lut), max_de00);
    Json json{{"maxDe00", bound.request.max_de00}};
    try {
        DecidedLut decided = decided_alone(scene(), bound);
        const BakedLut baked = bake_within_bound(decided, {});
        json["width"] = baked.image.width();
        json["height"] = baked.image.height();
        json["format"] = name_of(format_words, decided.lut.lut.format);
        json["bytes"] = exr_bytes(decided, baked);
        if (baked.reached) json["reached"] = *baked.reached;
        json["seconds"] = seconds_json(decided, baked);
    } catch (const Error& error) {
        json["failure"] = error.what();
    }
    return json;
}

std::string Session::exr(const std::string& lut) {
    const Entry& entry = baked(lut);
    return plain_exr(entry.baked->image, entry.decided.lut.lut.format, entry.baked->header);
}

std::string Session::manifest(const std::string& lut) {
    const Entry& entry = baked(lut);
    return manifest_text(entry.decided.lut, *entry.baked);
}

std::vector<double> Session::xyz(const std::string& lut) {
    const Image<Xyz> image = nacre::bake(baked(lut).decided.lut.lut.job);
    std::vector<double> numbers;
    for (const Xyz& texel : image) numbers.insert(numbers.end(), {texel.x, texel.y, texel.z});
    return numbers;
}

std::vector<float> Session::palette_field(const Lobe& lobe, double most_width_nm, int columns, int rows) const {
    const Light& light = *scene().plan.light;
    Image<Rgb> field(columns, rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            Lobe one = lobe;
            one.width_nm = most_width_nm * x / std::max(columns - 1, 1);
            one.height = static_cast<double>(y) / std::max(rows - 1, 1);
            field.at(x, y) = in_rec709(adapt(light.adaptation, lobe_to_xyz(light, one)));
        }
    }
    return components(field);
}

Json Session::find_structure(const std::string& material, const std::string& mechanism,
                             const std::function<void(int done)>& step) const {
    const SceneMaterial* const found = nacre::find_material(scene().plan, material);
    const auto* const palette = found != nullptr ? std::get_if<Palette>(&found->mechanism) : nullptr;
    if (palette == nullptr) throw Error("structures are found for the picks of a palette, and this is none");
    std::vector<PickLine> lines;
    for (std::size_t i = 0; i < palette->picks.size(); ++i) lines.push_back(pick_line(*found, *palette, i));
    SceneRequest request = page_request();
    request.all_materials = true;
    int done = 0;
    if (step) request.after_step = [&] { step(done++); };
    const std::string asked = "mechanism = " + toml_string(mechanism) + "\n";
    const Plan plan = plan_text(scene_text({material, asked, picks_toml(lines), "", false}), scene_name, request);
    const MaterialSearch& search = plan.searches.front();
    std::string summary;
    for (const PickedColour& picked : plan.materials.front().picked)
        summary += (summary.empty() ? "" : "; ") + picked.text + ": " + match_text(picked);
    return {{"text", scene_text({material, mechanism_toml(rounded_answer(search, 0)), picks_toml(lines), "", false})},
            {"summary", found_text(search.search, search.found.front()) + ". " + summary}};
}

}  // namespace nacre
