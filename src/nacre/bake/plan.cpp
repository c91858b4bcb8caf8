#include "nacre/bake/plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "nacre/bake/names.h"
#include "nacre/bake/swatch.h"
#include "nacre/error.h"

namespace nacre {
namespace {

constexpr Allowed allowed_version{1, 1};
constexpr Allowed allowed_wavelengths{2, 100000};
constexpr Allowed allowed_size{2, largest_lut_size, "texels"};
constexpr Allowed allowed_angle{0.0, 90.0, "degrees"};
constexpr std::size_t longest_name = 100;

constexpr int default_width = 256;
constexpr int default_height = 64;

// Names become file names on every system that an artist's files pass through.
void check_name(const std::string& name, const Table& table, const Where& where) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    if (name.empty() || name.size() > longest_name || name.front() == '.' || name.front() == '-' ||
        name.back() == '.' || !std::all_of(name.begin(), name.end(), allowed)) {
        table.fail(where, "the name " + in_quotes(name) + " cannot be a file's name; allowed are 1 to " +
                              std::to_string(longest_name) + " of A-Z a-z 0-9 _ - . (not first: - .)");
    }
}

int checked_size(const Table& table, std::string_view key, const Value& value) {
    const int size = table.checked_integer(key, value, allowed_size);
    if ((size & (size - 1)) != 0) {
        table.fail(value.where, std::string(key) + " = " + std::to_string(size) +
                                    " is no power of two; allowed 2, 4, 8 ... " + std::to_string(largest_lut_size) +
                                    " (engines rescale other sizes)");
    }
    return size;
}

// A size is a number, or [width, height] where there are two axes.
struct Size {
    std::optional<int> width;
    std::optional<int> height;
};

Size read_size(const Table& table) {
    const Value* value = table.find("size");
    if (value == nullptr) return {};
    if (!std::holds_alternative<Value::Array>(value->data)) return {checked_size(table, "size", *value), std::nullopt};
    const Value::Array& sides = table.checked_array("size", *value);
    if (sides.size() != 2) {
        table.fail(value->where, "size has " + std::to_string(sides.size()) + " numbers; give one, or [width, height]");
    }
    return {checked_size(table, "size", sides[0]), checked_size(table, "size", sides[1])};
}

// Reads one scene; holds what its tables refer to each other by.
class Planner {
public:
    Planner(const Table& scene, const CurveReader& read_curve) : scene_(scene), read_curve_(read_curve) {}

    Plan plan() {
        scene_.integer_or("nacre", allowed_version, 1);
        read_accuracy();
        plan_.light =
            std::make_shared<const Light>(make_light(read_light(scene_.table("light"), wavelengths_, read_curve_)));
        check_white();
        read_colour();
        read_materials();
        read_luts();
        read_swatches();
        scene_.expect_all_read();
        check_outputs();
        return std::move(plan_);
    }

private:
    void read_accuracy() {
        const Table* table = scene_.table("accuracy");
        if (table == nullptr) return;
        const int none = 0;
        const int wavelengths = table->integer_or("wavelengths", allowed_wavelengths, none);
        if (wavelengths != none) wavelengths_ = wavelengths;
        size_ = read_size(*table);
        table->expect_all_read();
    }

    // A grid may step over all the light there is, and a table of power may have a white that no eye adapts to.
    void check_white() const {
        const Light& light = *plan_.light;
        if (light.settings.wavelengths && !(light.white().y > 0.5)) {
            scene_.table("accuracy")
                ->fail_at("wavelengths", "wavelengths = " + std::to_string(*light.settings.wavelengths) +
                                             " miss all the light of illuminant " +
                                             in_quotes(light.settings.illuminant) + "; give more of them");
        }
        const Xyz adapted = adapt(light.adaptation, light.white());
        const Xyz d65 = xyz_from_chromaticity(d65_chromaticity);
        const bool adapts =
            std::abs(adapted.x - d65.x) + std::abs(adapted.y - d65.y) + std::abs(adapted.z - d65.z) < 1e-9;
        if (light.settings.adaptation != Adaptation::none && !adapts) {
            scene_.table("light")->fail_at(
                "illuminant", "the white of illuminant " + in_quotes(light.settings.illuminant) +
                                  " cannot be adapted to D65; use adapt = \"none\" or a light with a broader spectrum");
        }
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
            colour.space_where = space->where;
        }
        colour.gamut = read_word(*table, "gamut", "gamut", gamut_words);
        colour.interchange = table->text_or("interchange", "");
        table->expect_all_read();
    }

    void read_materials() {
        const Table* materials = scene_.table("material");
        if (materials == nullptr || materials->entries().empty()) {
            scene_.fail(scene_.where(), "no [material.NAME]; a scene needs one");
        }
        for (const Table::Entry& entry : materials->entries()) {
            const Table& table = materials->checked_table(entry.key, entry.value);
            check_name(entry.key, *materials, entry.key_where);
            Material material{entry.key, read_mechanism(table), entry.key_where};
            table.expect_all_read();
            material_index_.emplace(entry.key, plan_.materials.size());
            plan_.materials.push_back(std::move(material));
        }
    }

    const Material& material_of(const Table& table) const {
        const Value* value = table.find("material");
        if (value == nullptr) {
            if (plan_.materials.size() == 1) return plan_.materials.front();
            table.fail(table.where(), "material is missing, and the scene has " +
                                          std::to_string(plan_.materials.size()) + "; say which");
        }
        const std::string& name = table.checked_text("material", *value);
        const auto found = material_index_.find(name);
        if (found != material_index_.end()) return plan_.materials[found->second];
        std::vector<std::string> known;
        for (const Material& material : plan_.materials) known.push_back(material.name);
        table.fail(value->where, "unknown material " + in_quotes(name) +
                                     "; known: " + comma_separated(nearest_names(name, known, 5)));
    }

    void read_luts() {
        const Table* luts = scene_.table("lut");
        if (luts == nullptr) {
            for (const Material& material : plan_.materials) {
                PlannedLut lut;
                lut.name = material.name;
                lut.job.material = material;
                lut.job.light = plan_.light;
                lut.job.width = size_.width.value_or(default_width);
                lut.where = material.where;
                plan_.luts.push_back(std::move(lut));
            }
            return;
        }
        for (const Table::Entry& entry : luts->entries()) {
            const Table& table = luts->checked_table(entry.key, entry.value);
            check_name(entry.key, *luts, entry.key_where);
            plan_.luts.push_back(read_lut(table, entry));
        }
    }

    PlannedLut read_lut(const Table& table, const Table::Entry& entry) const {
        PlannedLut lut;
        lut.name = entry.key;
        lut.where = entry.key_where;
        Job& job = lut.job;
        job.material = material_of(table);
        job.light = plan_.light;
        if (const Value* x = table.find("x")) job.x = read_axis(table, "x", *x, job.material.mechanism);
        if (const Value* y = table.find("y")) {
            job.y = read_axis(table, "y", *y, job.material.mechanism);
            check_axes_differ(job, table, y->where);
        }
        read_fixed_angle(table, job);
        read_job_size(table, job);
        lut.format = read_word(table, "format", "format", format_words);
        read_outputs(table, lut);
        table.expect_all_read();
        return lut;
    }

    static void check_axes_differ(const Job& job, const Table& table, const Where& where) {
        if (job.x.is_angle() && job.y->is_angle())
            table.fail(where, "x and y are both the angle; one of them has to be a parameter");
        if (job.x.is_angle() || job.y->is_angle()) return;
        const std::string& x = job.x.parameter.name;
        const std::string& y = job.y->parameter.name;
        const bool overlap = x == y || x.ends_with("]." + y) || y.ends_with("]." + x);
        if (overlap) table.fail(where, "x and y both set " + y + "; give two different parameters");
    }

    static void read_fixed_angle(const Table& table, Job& job) {
        const bool has_angle = job.x.is_angle() || (job.y && job.y->is_angle());
        const Value* value = table.find("angle_deg");
        if (value == nullptr) return;
        if (has_angle) table.fail(value->where, "angle_deg is fixed, but an axis is the angle; leave one of them out");
        job.angle_deg = table.checked_number("angle_deg", *value, allowed_angle);
    }

    void read_job_size(const Table& table, Job& job) const {
        const Size own = read_size(table);
        if (own.height && !job.y) table.fail_at("size", "size has two numbers, but there is no y axis; give one");
        job.width = own.width ? *own.width : size_.width.value_or(default_width);
        if (job.y)
            job.height = own.height ? *own.height : own.width ? *own.width : size_.height.value_or(default_height);
    }

    static void read_outputs(const Table& table, PlannedLut& lut) {
        const Value* value = table.find("outputs");
        if (value == nullptr) return;
        lut.outputs.clear();
        for (const std::string& name : table.texts("outputs")) {
            const LutOutput output = meaning_of(output_words, "output", name, table, value->where);
            if (std::find(lut.outputs.begin(), lut.outputs.end(), output) == lut.outputs.end())
                lut.outputs.push_back(output);
        }
        if (lut.outputs.empty())
            table.fail(value->where, "outputs is empty; known: " + comma_separated(names_of(output_words)));
    }

    void read_swatches() {
        const Table* swatches = scene_.table("swatch");
        if (swatches == nullptr) return;
        for (const Table::Entry& entry : swatches->entries()) {
            const Table& table = swatches->checked_table(entry.key, entry.value);
            check_name(entry.key, *swatches, entry.key_where);
            plan_.swatches.push_back(read_swatch(table, entry));
        }
    }

    PlannedSwatch read_swatch(const Table& table, const Table::Entry& entry) const;
    void check_outputs() const;

    const Table& scene_;
    const CurveReader& read_curve_;
    Plan plan_;
    std::optional<int> wavelengths_;
    Size size_;
    std::map<std::string, std::size_t, std::less<>> material_index_;
};

PlannedSwatch Planner::read_swatch(const Table& table, const Table::Entry& entry) const {
    PlannedSwatch swatch;
    swatch.name = entry.key;
    swatch.where = entry.key_where;
    swatch.kind = meaning_of(swatch_words, "swatch", table.text("draw"), table, table.find("draw")->where);
    swatch.display = table.text_or("display", "");
    swatch.view = table.text_or("view", "");
    swatch.gamut = read_word(table, "gamut", "gamut", swatch_gamut_words);

    if (swatch.kind == SwatchKind::strip || swatch.kind == SwatchKind::sphere) {
        if (const Value* value = table.find("lut")) {
            const std::string& name = table.checked_text("lut", *value);
            const auto found = std::find_if(plan_.luts.begin(), plan_.luts.end(),
                                            [&](const PlannedLut& lut) { return lut.name == name; });
            if (found == plan_.luts.end()) {
                std::vector<std::string> known;
                for (const PlannedLut& lut : plan_.luts) known.push_back(lut.name);
                table.fail(value->where, "unknown lut " + in_quotes(name) +
                                             "; known: " + comma_separated(nearest_names(name, known, 5)));
            }
            if (table.find("material") != nullptr)
                table.fail_at("material", "a swatch shows a material or a lut; leave one of them out");
            swatch.jobs.push_back(found->job);
        }
    }
    if (swatch.jobs.empty()) {
        const Material& material = material_of(table);
        std::vector<Job> jobs = swatch_jobs(swatch.kind, material, plan_.light);
        swatch.picks.resize(jobs.size());
        for (std::size_t i = 0; i < jobs.size(); ++i) swatch.picks[i] = i;
        if (swatch.kind == SwatchKind::palette) {
            const Allowed allowed_pick{0.0, static_cast<double>(jobs.size() - 1)};
            const int pick = table.integer_or("pick", allowed_pick, -1);
            if (pick >= 0) {
                const auto index = static_cast<std::size_t>(pick);
                jobs = {jobs[index]};
                swatch.picks = {index};
            }
        }
        swatch.jobs = std::move(jobs);
    }
    swatch.title = table.text_or("title", swatch.jobs.front().material.name);
    table.expect_all_read();
    return swatch;
}

// Names are compared without case: the files go to systems that do not tell Morpho.exr from morpho.exr.
void Planner::check_outputs() const {
    std::map<std::string, Where> taken;
    const auto claim = [&](const std::string& file, const Where& where) {
        std::string key = file;
        std::transform(key.begin(), key.end(), key.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        const auto [first, is_new] = taken.emplace(key, where);
        if (is_new) return;
        throw Error(where.text() + ": this would write " + file + ", and so would " + first->second.text() +
                    "; rename one of them");
    };
    for (const PlannedLut& lut : plan_.luts) {
        for (const LutOutput output : lut.outputs)
            claim(lut.name + "." + std::string(name_of(output_words, output)), lut.where);
    }
    for (const PlannedSwatch& swatch : plan_.swatches) claim(swatch.name + ".png", swatch.where);
}

}  // namespace

Plan plan_scene(const Table& scene, const CurveReader& read_curve) {
    return Planner(scene, read_curve).plan();
}

}  // namespace nacre
