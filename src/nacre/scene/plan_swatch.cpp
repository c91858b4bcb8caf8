// [swatch.NAME]: what a picture shows, as the jobs that are baked for it.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {
namespace {

// Whether it is an object in a light.
bool is_lit(SwatchKind kind) {
    return kind == SwatchKind::sphere || kind == SwatchKind::bubble || kind == SwatchKind::disc ||
           kind == SwatchKind::puddle;
}

// Whether it shows the colours of a LUT over their axes.
bool has_strip(SwatchKind kind) {
    return kind == SwatchKind::strip || kind == SwatchKind::preview;
}

// Leaves the swatch without jobs if the LUT or its material has mistakes.
void show_lut(const Table& table, const Value& value, const SceneParts& parts,
              const std::vector<std::string>& lut_names, PlannedSwatch& swatch) {
    if (table.find("material") != nullptr)
        table.note_at("material", "a swatch shows a material or a lut; remove one of them");
    const std::string& name = table.checked_text("lut", value);
    const NamedLut found = lut_named(parts, name);
    if (!found.exists)
        table.note(value.where, "unknown lut " + in_quotes(name) + "; known: " + known_like(name, lut_names));
    if (!found.lut) return;
    swatch.jobs = {found.lut->job};
    swatch.colour = found.lut->colour;
}

void check_shows_something(const Table& table, SwatchKind kind, const SceneMaterial& material) {
    const bool needs_palette = kind == SwatchKind::plane || kind == SwatchKind::palette;
    if (needs_palette && !std::holds_alternative<Palette>(material.mechanism)) {
        table.fail_at("draw", "draw = " + in_quotes(name_of(swatch_words, kind)) +
                                  " shows the picks of a palette, and material " + in_quotes(material.name) + " is a " +
                                  std::string(mechanism_name(material.mechanism)) + "; draw a strip or a sphere");
    }
    if (kind == SwatchKind::picks && material.picked.empty()) {
        table.fail_at("draw", "draw = \"picks\" shows picks that are colours, and material " +
                                  in_quotes(material.name) + " has none; give them as colour = \"#rrggbb\"");
    }
}

void show_material(const Table& table, const SceneParts& parts, PlannedSwatch& swatch) {
    const SceneMaterial* material = material_of(table, parts.materials);
    if (material == nullptr) {
        table.skip("pick");
        return;
    }
    check_shows_something(table, swatch.kind, *material);
    swatch.jobs = swatch_jobs(swatch.kind, *material, parts.light);
    swatch.picked = material->picked;
    if (swatch.kind != SwatchKind::palette) return;
    const Allowed allowed_pick{0.0, static_cast<double>(swatch.jobs.size() - 1)};
    const int pick = table.integer_or("pick", allowed_pick, -1);
    if (pick < 0) return;
    swatch.jobs = {Job(swatch.jobs[static_cast<std::size_t>(pick)])};
}

// A contact sheet: all LUTs of the scene, whichever are wanted.
void show_all_luts(const Table& table, const SceneParts& parts, PlannedSwatch& swatch) {
    swatch.panels = read_word(table, "panels", "panels", sheet_words);
    for (PlannedLut& lut : plan_luts(parts, {}).luts) {
        swatch.labels.push_back(lut.name);
        swatch.jobs.push_back(std::move(lut.job));
    }
}

void refuse(const Table& table, std::string_view key, SwatchKind kind, std::string_view draws) {
    if (table.find(key) == nullptr) return;
    table.note_at(key, std::string(key) + " has no meaning for draw = " + in_quotes(name_of(swatch_words, kind)) +
                           "; remove it, or draw " + std::string(draws));
}

// What only some pictures know: the exposure, and what a strip is even in.
void read_view(const Table& table, PlannedSwatch& swatch) {
    constexpr Allowed allowed_ev{-20.0, 20.0, "EV"};
    if (!has_strip(swatch.kind) && !is_lit(swatch.kind) && swatch.kind != SwatchKind::contact_sheet)
        refuse(table, "exposure", swatch.kind, "a strip, sphere, bubble, disc or puddle");
    if (!has_strip(swatch.kind)) refuse(table, "x", swatch.kind, "a strip");
    if (table.find("exposure") != nullptr) swatch.exposure_ev = table.number("exposure", allowed_ev);
    const Value* x = table.find("x");
    if (x == nullptr) return;
    const std::string& name = table.checked_text("x", *x);
    std::vector<std::string> known;
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.quantity != Quantity::incidence) continue;
        known.emplace_back(kind.name);
        if (kind.name == name) swatch.shown_axis = &kind;
    }
    if (swatch.shown_axis->name != name)
        table.note(x->where, "unknown axis " + in_quotes(name) + "; known: " + comma_separated(known));
}

// An object shows a material that depends on what the object shows.
void check_suits(const Table& table, const PlannedSwatch& swatch) {
    if (swatch.jobs.empty()) return;
    const Material& material = swatch.jobs.front().material;
    const Quantity quantity = quantity_of(material.mechanism);
    const auto refuse_material = [&](std::string_view shown, std::string_view instead) {
        table.note_at("draw", "draw = " + in_quotes(name_of(swatch_words, swatch.kind)) + " shows " +
                                  std::string(shown) + ", and material " + in_quotes(material.name) + " is a " +
                                  std::string(mechanism_name(material.mechanism)) + "; draw " + std::string(instead));
    };
    if (swatch.kind == SwatchKind::disc && quantity != Quantity::grating_u) refuse_material("a grating", "a sphere");
    if (is_transmittance(material.mechanism) && is_lit(swatch.kind) && swatch.kind != SwatchKind::sphere &&
        swatch.kind != SwatchKind::bubble)
        table.note_at("draw",
                      "draw = " + in_quotes(name_of(swatch_words, swatch.kind)) +
                          " shows reflected light, and this lut is of transmittance; draw a sphere or a bubble");
    const bool needs_angle = swatch.kind == SwatchKind::bubble || swatch.kind == SwatchKind::puddle;
    if (needs_angle && quantity != Quantity::incidence)
        refuse_material("colours that depend on the angle to the normal", "a sphere");
}

// @return nothing if there are mistakes
std::optional<PlannedSwatch> read_swatch(const Table& table, const Table::Entry& entry, const SceneParts& parts,
                                         const std::vector<std::string>& lut_names) {
    PlannedSwatch swatch;
    swatch.name = entry.key;
    swatch.where = entry.key_where;
    swatch.colour = parts.colour;
    const std::string draw = table.text("draw");
    swatch.kind = meaning_of(swatch_words, "swatch", draw, table, table.find("draw")->where);
    swatch.display = table.text_or("display", "");
    swatch.view = table.text_or("view", "");
    swatch.gamut = read_word(table, "gamut", "gamut", swatch_gamut_words);
    read_view(table, swatch);
    const bool may_show_lut = has_strip(swatch.kind) || is_lit(swatch.kind);
    const Value* lut = may_show_lut ? table.find("lut") : nullptr;
    if (swatch.kind == SwatchKind::contact_sheet) {
        show_all_luts(table, parts, swatch);
    } else if (lut != nullptr) {
        show_lut(table, *lut, parts, lut_names, swatch);
    } else {
        show_material(table, parts, swatch);
    }
    check_suits(table, swatch);
    const bool shows_one = swatch.kind != SwatchKind::contact_sheet && !swatch.jobs.empty();
    swatch.title = table.text_or("title", shows_one ? swatch.jobs.front().material.name : swatch.name);
    table.expect_all_read();
    if (swatch.jobs.empty() || !table.is_good()) return {};
    return swatch;
}

}  // namespace

PlannedSwatches plan_swatches(const SceneParts& parts, const PlanRequest& request,
                              const std::vector<std::string>& lut_names) {
    PlannedSwatches planned;
    const Table* swatches = nullptr;
    attempt(parts.scene, parts.scene.where(), [&] { swatches = parts.scene.table("swatch"); });
    if (swatches == nullptr) return planned;
    for (const Table::Entry& entry : swatches->entries()) {
        check_name(entry.key, *swatches, entry.key_where);
        planned.names.push_back(entry.key);
        if (!request.wants(entry.key)) continue;
        attempt(*swatches, entry.key_where, [&] {
            const Table& table = swatches->checked_table(entry.key, entry.value);
            auto swatch = read_swatch(table, entry, parts, lut_names);
            if (swatch) planned.swatches.push_back(std::move(*swatch));
        });
    }
    return planned;
}

}  // namespace nacre
