#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/base/names.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"

namespace nacre {
namespace {

// The peaks that a plane shows: the visible ones.
constexpr double shortest_peak_nm = 380.0;
constexpr double longest_peak_nm = 780.0;

Axis angle_axis(std::string_view name) {
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.name == name) return {&kind, {}, 0.0, 1.0};
    }
    return default_axis();
}

// The LUT that the key `lut` names.
const PlannedLut& lut_of(const Table& table, const Value& value, const LutFinder& find_lut) {
    const std::string& name = table.checked_text("lut", value);
    std::vector<std::string> known;
    if (const PlannedLut* lut = find_lut(name, known)) return *lut;
    table.fail(value.where, "unknown lut " + in_quotes(name) + "; known: " + known_like(name, known));
}

void show_lut(const Table& table, const Value& value, const LutFinder& find_lut, PlannedSwatch& swatch) {
    if (table.find("material") != nullptr) {
        table.fail_at("material", "a swatch shows a material or a lut; leave one of them out");
    }
    swatch.jobs = {lut_of(table, value, find_lut).job};
}

void show_material(const Table& table, Materials& materials, const std::shared_ptr<const Light>& light,
                   PlannedSwatch& swatch) {
    const SceneMaterial& material = material_of(table, materials);
    const bool needs_picks = swatch.kind == SwatchKind::plane || swatch.kind == SwatchKind::palette;
    if (needs_picks && !std::holds_alternative<Palette>(material.mechanism)) {
        table.fail_at("draw", "draw = " + in_quotes(name_of(swatch_words, swatch.kind)) +
                                  " shows the picks of a palette, and material " + in_quotes(material.name) + " is a " +
                                  std::string(mechanism_name(material.mechanism)) + "; draw a strip or a sphere");
    }
    if (swatch.kind == SwatchKind::picks && material.picked.empty()) {
        table.fail_at("draw", "draw = \"picks\" shows picks that are colours, and material " +
                                  in_quotes(material.name) + " has none; give them as colour = \"#rrggbb\"");
    }
    swatch.jobs = swatch_jobs(swatch.kind, material, light);
    swatch.picked = material.picked;
    if (swatch.kind != SwatchKind::palette) return;
    const Allowed allowed_pick{0.0, static_cast<double>(swatch.jobs.size() - 1)};
    const int pick = table.integer_or("pick", allowed_pick, -1);
    if (pick < 0) return;
    swatch.jobs = {Job(swatch.jobs[static_cast<std::size_t>(pick)])};
}

}  // namespace

std::vector<Job> swatch_jobs(SwatchKind kind, const Material& material, const std::shared_ptr<const Light>& light) {
    Job job;
    job.material = material;
    job.light = light;
    switch (kind) {
        case SwatchKind::plane:
            job.x = parameter_axis(material.mechanism, "peak_nm", shortest_peak_nm, longest_peak_nm);
            job.y = angle_axis("theta_deg");
            job.width = 1046;
            job.height = 560;
            return {job};
        case SwatchKind::palette: {
            constexpr double round_nm = 50.0;
            const auto& picks = std::get<Palette>(material.mechanism).picks;
            double widest_nm = 200.0;
            for (const Pick& pick : picks) widest_nm = std::max(widest_nm, 1.25 * pick.lobe.width_nm);
            widest_nm = std::min(round_nm * std::ceil(widest_nm / round_nm), 1000.0);
            std::vector<Job> jobs;
            for (const Pick& pick : picks) {
                // At its own angle a pick is alone, so that its panel costs the same whatever else was picked.
                job.material.mechanism = Palette{{pick}};
                job.x = parameter_axis(job.material.mechanism, "width_nm", 0.0, widest_nm);
                job.y = parameter_axis(job.material.mechanism, "height", 0.0, 1.0);
                job.fixed = Incidence::from_degrees(pick.angle_deg);
                job.width = job.height = 475;
                jobs.push_back(job);
            }
            return jobs;
        }
        case SwatchKind::strip:
        case SwatchKind::sphere:
        case SwatchKind::picks:
            job.x = default_axis(quantity_of(material.mechanism));
            job.width = 1100;
            return {job};
    }
    return {};
}

PlannedSwatch read_swatch(const Table& table, const Table::Entry& entry, Materials& materials,
                          const std::shared_ptr<const Light>& light, const LutFinder& find_lut) {
    PlannedSwatch swatch;
    swatch.name = entry.key;
    swatch.where = entry.key_where;
    const std::string draw = table.text("draw");
    swatch.kind = meaning_of(swatch_words, "swatch", draw, table, table.find("draw")->where);
    swatch.display = table.text_or("display", "");
    swatch.view = table.text_or("view", "");
    swatch.gamut = read_word(table, "gamut", "gamut", swatch_gamut_words);
    const bool may_show_lut = swatch.kind == SwatchKind::strip || swatch.kind == SwatchKind::sphere;
    const Value* lut = may_show_lut ? table.find("lut") : nullptr;
    if (lut != nullptr) {
        show_lut(table, *lut, find_lut, swatch);
    } else {
        show_material(table, materials, light, swatch);
    }
    swatch.title = table.text_or("title", swatch.jobs.front().material.name);
    table.expect_all_read();
    return swatch;
}

}  // namespace nacre
