#include "nacre/bake/plan.h"

#include "nacre/bake/names.h"
#include "nacre/bake/output_names.h"
#include "nacre/bake/plan_tables.h"
#include "nacre/bake/sampler.h"

namespace nacre {
namespace {

constexpr Allowed allowed_version{1, 1};

// Reads one scene; holds what its tables refer to each other by.
class Planner {
public:
    Planner(const Table& scene, const SceneFiles& files) : scene_(scene), files_(files) {}

    Plan plan() {
        scene_.integer_or("nacre", allowed_version, 1);
        accuracy_ = read_accuracy(scene_.table("accuracy"));
        plan_.light = std::make_shared<const Light>(
            make_light(read_light(scene_.table("light"), accuracy_.wavelengths, files_.read_curve)));
        check_white();
        read_colour();
        read_materials();
        read_luts();
        read_swatches();
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

    void read_materials() {
        const Table* materials = scene_.table("material");
        if (materials == nullptr || materials->entries().empty()) {
            scene_.fail_missing("material", "a scene needs a [material.NAME]");
        }
        for (const Table::Entry& entry : materials->entries()) {
            const Table& table = materials->checked_table(entry.key, entry.value);
            check_name(entry.key, *materials, entry.key_where);
            const IndexReader reader{files_.find_material, static_cast<double>(plan_.light->settings.first_nm),
                                     static_cast<double>(plan_.light->settings.last_nm)};
            Material material{entry.key, read_mechanism(table, reader), entry.key_where};
            table.expect_all_read();
            check_fringes(table, material.mechanism);
            plan_.materials.push_back(std::move(material));
        }
    }

    void read_luts() {
        const Table* luts = scene_.table("lut");
        if (luts == nullptr) {
            for (const Material& material : plan_.materials) {
                PlannedLut lut;
                lut.name = material.name;
                lut.job.material = material;
                lut.job.light = plan_.light;
                take_wish(default_wish(accuracy_, false), lut);
                lut.where = material.where;
                plan_.luts.push_back(std::move(lut));
            }
            return;
        }
        for (const Table::Entry& entry : luts->entries()) {
            const Table& table = luts->checked_table(entry.key, entry.value);
            check_name(entry.key, *luts, entry.key_where);
            plan_.luts.push_back(read_lut(table, entry, plan_.materials, plan_.light, accuracy_));
            check_fringes(table, plan_.luts.back().job);
        }
    }

    void read_swatches() {
        const Table* swatches = scene_.table("swatch");
        if (swatches == nullptr) return;
        for (const Table::Entry& entry : swatches->entries()) {
            const Table& table = swatches->checked_table(entry.key, entry.value);
            check_name(entry.key, *swatches, entry.key_where);
            plan_.swatches.push_back(read_swatch(table, entry, plan_));
        }
    }

    const Table& scene_;
    const SceneFiles& files_;
    Plan plan_;
    AccuracySettings accuracy_;
};

}  // namespace

std::string size_text(const Job& job) {
    return std::to_string(job.width) + " x " + std::to_string(job.height);
}

std::string integration_text(const Job& job) {
    if (!needs_sampling(job.material.mechanism) && !job.light->settings.wavelengths)
        return std::string(name_of(integral_words, job.integral));
    std::string text;
    if (job.light->settings.wavelengths) {
        text = std::to_string(*job.light->settings.wavelengths) + " wavelengths";
    } else {
        // The same number in all bands is said once.
        std::string counts;
        int last = 0;
        for (const int count : job.sampling.node_counts()) {
            if (count != last) counts += (counts.empty() ? "" : "/") + std::to_string(count);
            last = count;
        }
        text = counts + " nodes";
    }
    if (job.sampling.realisations > 1) text += " x " + std::to_string(job.sampling.realisations);
    return text;
}

Plan plan_scene(const Table& scene, const SceneFiles& files) {
    return Planner(scene, files).plan();
}

}  // namespace nacre
