#include "nacre/scene/plan.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/sampler.h"
#include "nacre/pick/missed_picks.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/light_reader.h"
#include "nacre/scene/readers/pick_reader.h"
#include "nacre/shade/measured_colour.h"

namespace nacre {
namespace {

constexpr Allowed allowed_version{1, 1};

// Reads one scene; holds what its tables refer to each other by.
class Planner {
public:
    Planner(const Table& scene, const SceneFiles& files, const PlanRequest& request)
        : scene_(scene), files_(files), request_(request) {}

    Plan plan() {
        scene_.integer_or("nacre", allowed_version, 1);
        accuracy_ = read_accuracy(scene_.table("accuracy"));
        plan_.light = std::make_shared<const Light>(
            make_light(read_light(scene_.table("light"), accuracy_.wavelengths, files_.read_curve)));
        check_white();
        read_colour();
        const LightSettings& light = plan_.light->settings;
        SceneContext context{
            {files_.find_material, static_cast<double>(light.first_nm), static_cast<double>(light.last_nm)},
            files_.read_curve,
            files_.read_spectra,
            pick_readers()};
        if (files_.find_mechanisms) {
            context.find_mechanisms = [&](const MechanismSearch& search) {
                return files_.find_mechanisms(search, *plan_.light);
            };
        }
        Materials materials(material_table(), context,
                            [&](const Table& table, const Mechanism& mechanism) { check_fringes(table, mechanism); });
        read_luts(materials);
        read_swatches(materials);
        if (request_.all_materials) {
            for (const std::string& name : materials.names()) materials.named(name);
        }
        plan_.materials = materials.read();
        plan_.searches = materials.searches();
        judge_picked_colours();
        warn_of_single_picks();
        warn_of_black_gratings();
        scene_.expect_all_read();
        OutputNames().claim(plan_);
        return std::move(plan_);
    }

private:
    // A grid may step over all the light there is, and a table of power may have a white that no eye adapts to.
    void check_white() const {
        const Light& light = *plan_.light;
        if (light.settings.wavelengths && !(light.white().y > 0.5)) {
            scene_.table("accuracy")
                ->fail_at("wavelengths", "wavelengths = " + std::to_string(*light.settings.wavelengths) +
                                             " miss all the light of illuminant " +
                                             in_quotes(light.settings.illuminant) + "; give more of them");
        }
        if (can_adapt_from(light.settings.adaptation, light.white())) return;
        const Table* table = scene_.table("light");
        const std::string message =
            "the white of illuminant " + in_quotes(light.settings.illuminant) +
            " cannot be adapted to D65; use adapt = \"none\", more wavelengths, or a broader spectrum";
        table != nullptr ? table->fail_at("illuminant", message) : scene_.fail_at("accuracy", message);
    }

    // Where an axis may lead to.
    void check_fringes(const Table& lut, const Job& job) const {
        const bool moves = !job.x.is_angle() || (job.y && !job.y->is_angle());
        if (!moves) return;
        for (const double x : {0.0, 1.0}) {
            for (const double y : {0.0, 1.0}) check_fringes(lut, mechanism_at(job, x, y));
        }
    }

    void check_fringes(const Table& table, const Mechanism& mechanism) const {
        const double fringes = fringe_count(mechanism, plan_.light->settings);
        if (fringes <= most_fringes) return;
        table.fail(table.where(), "the layers are so thick that " + significant_text(fringes, 3) +
                                      " fringes lie in the light's range; allowed " + number_text(most_fringes) +
                                      "; in a stack a thick layer may be marked incoherent = true");
    }

    void read_colour() {
        const Table* table = scene_.table("colour");
        if (table == nullptr) return;
        ColourSettings& colour = plan_.colour;
        if (const Value* config = table->find("config")) {
            colour.config = table->checked_text("config", *config);
            colour.config_where = config->where;
            if (colour.config.empty()) table->fail(config->where, "config is empty; name a file, or leave the key out");
        }
        colour.space_where = table->where();
        if (const Value* space = table->find("space")) {
            colour.space = table->checked_text("space", *space);
            colour.is_space_given = true;
            colour.space_where = space->where;
        }
        colour.gamut = read_word(*table, "gamut", "gamut", gamut_words);
        colour.interchange = table->text_or("interchange", "");
        table->expect_all_read();
    }

    const Table& material_table() const {
        const Table* materials = scene_.table("material");
        if (materials == nullptr || materials->entries().empty())
            scene_.fail_missing("material", "a scene needs a [material.NAME]");
        return *materials;
    }

    void read_luts(Materials& materials) {
        lut_table_ = scene_.table("lut");
        if (lut_table_ == nullptr) {
            for (const std::string& name : materials.names()) {
                plan_.names.push_back(name);
                if (request_.wants(name) || request_.wants(name + "_s") || request_.wants(name + "_p"))
                    add_lut(default_lut(materials.named(name)));
            }
            return;
        }
        for (const Table::Entry& entry : lut_table_->entries()) {
            const Table& table = lut_table_->checked_table(entry.key, entry.value);
            check_name(entry.key, *lut_table_, entry.key_where);
            plan_.names.push_back(entry.key);
            if (!request_.wants(entry.key) && !request_.wants(entry.key + "_s") && !request_.wants(entry.key + "_p"))
                continue;
            PlannedLut lut = read_lut(table, entry, materials, plan_.light, accuracy_);
            check_fringes(table, lut.job);
            add_lut(std::move(lut));
        }
    }

    // The LUT of a material in a scene that names none.
    PlannedLut default_lut(const Material& material) const {
        PlannedLut lut;
        lut.name = material.name;
        lut.job.material = material;
        lut.job.light = plan_.light;
        lut.job.x = default_axis(quantity_of(material.mechanism));
        take_wish(default_wish(accuracy_, false), lut);
        lut.where = material.where;
        return lut;
    }

    // One LUT, or two of a material that asks for both polarisations.
    void add_lut(PlannedLut lut) {
        Effects& effects = lut.job.material.mechanism.effects;
        if (!effects.both_polarisations) {
            plan_.luts.push_back(std::move(lut));
            return;
        }
        const std::string name = lut.name;
        effects.both_polarisations = false;
        for (const auto& [suffix, polarisation] : {std::pair{"_s", Polarisation::s}, {"_p", Polarisation::p}}) {
            lut.name = name + suffix;
            effects.polarisation = polarisation;
            plan_.names.push_back(lut.name);
            if (request_.wants(name) || request_.wants(lut.name)) plan_.luts.push_back(lut);
        }
        std::erase(plan_.names, name);
    }

    PickReaders pick_readers() {
        return {
            [this](const Rgb& colour, const std::string& space, const Where& where) {
                if (!files_.read_colour)
                    throw Error(where.text() + ": a colour needs an OpenColorIO config, and there is none here");
                return files_.read_colour(colour, space, where, plan_.colour);
            },
            [this](const Xyz& colour) { return lobe_finder().find(colour); },
            [this](const Lobe& lobe) {
                const Light& light = *plan_.light;
                return adapt(light.adaptation, lobe_to_xyz(light.weights, lobe.peak_nm, lobe.width_nm, lobe.height));
            },
            [this](const MeasuredSpectra& spectra, double angle_deg) {
                const Light& light = *plan_.light;
                return adapt(light.adaptation, MeasuredColour(spectra, light).at(Incidence::from_degrees(angle_deg)));
            }};
    }

    // Made when the first colour is picked.
    const LobeFinder& lobe_finder() {
        const Light& light = *plan_.light;
        if (!lobe_finder_) lobe_finder_.emplace(light.weights, light.moments, light.adaptation, files_.least_squares);
        return *lobe_finder_;
    }

    // Of a material whose numbers are all given, who bakes it knows what it misses; the plan says it still.
    void judge_picked_colours() {
        for (const SceneMaterial& material : plan_.materials) {
            for (const MissedPick& missed : missed_picks(material.picked)) {
                const PickedColour& picked = missed.picked;
                if (!picked.is_searched && !request_.strict) continue;
                const std::string message = picked.where.text() + " [material." + material.name + "]: picks[" +
                                            std::to_string(picked.pick) + "], " + picked.text + ": " + missed.text;
                if (request_.strict) throw Error(message);
                plan_.warnings.push_back(message);
            }
        }
    }

    void warn_of_single_picks() {
        for (const SceneMaterial& material : plan_.materials) {
            const auto* palette = std::get_if<Palette>(&material.mechanism);
            if (palette == nullptr || palette->picks.size() != 1) continue;
            plan_.warnings.push_back(material.where.text() + " [material." + material.name +
                                     "]: one pick says nothing about other angles: the same colour at all of them");
        }
    }

    void warn_of_black_gratings() {
        for (const SceneMaterial& material : plan_.materials) {
            const auto* grating = std::get_if<Grating>(&material.mechanism);
            if (grating == nullptr) continue;
            const std::string where = material.where.text() + " " + material.name + ": ";
            if (counted_orders(*grating, plan_.light->settings.first_nm).empty()) {
                plan_.warnings.push_back(where +
                                         "no order of the grating that counts can be seen: its grooves are too close "
                                         "together, and everything that shows it is black");
            } else if (2.0 * share_across(*grating) * grating->period_nm <
                       counted_orders(*grating, plan_.light->settings.first_nm).front() *
                           static_cast<double>(plan_.light->settings.first_nm)) {
                plan_.warnings.push_back(where +
                                         "no order of the grating that counts can be seen at its azimuth_deg, so far "
                                         "beside the plane across the grooves, and what shows it there is black");
            } else if (grating->azimuth_deg > 0.0 && grating->groove_length_um == 0.0) {
                plan_.warnings.push_back(where +
                                         "endless grooves send no light aside, and everything that shows them from "
                                         "azimuth_deg > 0 is black; give groove_length_um");
            }
        }
    }

    // A LUT that a swatch shows need not be one that is asked for.
    const PlannedLut* find_lut(const std::string& name, std::vector<std::string>& known, Materials& materials) {
        for (const PlannedLut& lut : plan_.luts) {
            if (lut.name == name) return &lut;
        }
        known = plan_.names;
        if (std::find(known.begin(), known.end(), name) == known.end()) return nullptr;
        const Plan before = plan_;
        const PlanRequest request = std::exchange(request_, PlanRequest{{name}, false});
        plan_.luts.clear();
        plan_.names.clear();
        read_luts(materials);
        for (PlannedLut& lut : plan_.luts) shown_luts_.push_back(std::move(lut));
        plan_ = before;
        request_ = request;
        return &shown_luts_.back();
    }

    void read_swatches(Materials& materials) {
        const Table* swatches = scene_.table("swatch");
        if (swatches == nullptr) return;
        std::vector<std::string> names;
        const LutFinder find = [&](const std::string& name, std::vector<std::string>& known) {
            return find_lut(name, known, materials);
        };
        for (const Table::Entry& entry : swatches->entries()) {
            const Table& table = swatches->checked_table(entry.key, entry.value);
            check_name(entry.key, *swatches, entry.key_where);
            names.push_back(entry.key);
            if (request_.wants(entry.key))
                plan_.swatches.push_back(read_swatch(table, entry, materials, plan_.light, find));
        }
        plan_.names.insert(plan_.names.end(), names.begin(), names.end());
    }

    const Table& scene_;
    const SceneFiles& files_;
    PlanRequest request_;
    Plan plan_;
    AccuracySettings accuracy_;
    const Table* lut_table_ = nullptr;
    std::optional<LobeFinder> lobe_finder_;
    std::deque<PlannedLut> shown_luts_;
};

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
    return Planner(scene, files, request).plan();
}

}  // namespace nacre
