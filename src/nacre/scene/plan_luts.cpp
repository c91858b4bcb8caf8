// [lut]: which LUTs a scene has, and under which names. read_lut() reads one of them (plan_lut.cpp).
//
// A scene without [lut] has one per material, with all defaults. A material with polarisation = "both" makes two of
// each of its LUTs, NAME_s and NAME_p; this is known only once the material is read. So a LUT that nobody wants keeps
// its own name among PlannedLuts::names, where it can be asked for as NAME, NAME_s or NAME_p.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/lut/axis.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {
namespace {

constexpr std::pair<std::string_view, Polarisation> polarised[] = {{"_s", Polarisation::s}, {"_p", Polarisation::p}};

// A LUT of the scene: [lut.NAME], or the default one of the material `name`.
struct LutEntry {
    std::string name;
    const Table* luts = nullptr;  // null: of a material
    const Table::Entry* entry = nullptr;
};

std::vector<LutEntry> lut_entries(const SceneParts& parts) {
    std::vector<LutEntry> entries;
    const Table* luts = nullptr;
    if (!attempt(parts.scene, parts.scene.where(), [&] { luts = parts.scene.table("lut"); })) return {};
    if (luts == nullptr) {
        for (const std::string& name : parts.materials.names()) entries.push_back({name});
        return entries;
    }
    for (const Table::Entry& entry : luts->entries()) {
        check_name(entry.key, *luts, entry.key_where);
        entries.push_back({entry.key, luts, &entry});
    }
    return entries;
}

std::optional<PlannedLut> default_lut(const std::string& name, const SceneParts& parts) {
    const SceneMaterial* material = parts.materials.named(name);
    if (material == nullptr) return {};
    PlannedLut lut;
    lut.name = name;
    lut.job.material = *material;
    lut.job.light = parts.light;
    lut.job.x = default_axis(quantity_of(material->mechanism));
    take_request(default_request(parts.accuracy, false), lut);
    lut.colour = parts.colour;
    lut.where = material->where;
    return lut;
}

std::optional<PlannedLut> read_entry(const LutEntry& entry, const SceneParts& parts) {
    if (entry.luts == nullptr) return default_lut(entry.name, parts);
    std::optional<PlannedLut> lut;
    attempt(*entry.luts, entry.entry->key_where,
            [&] { lut = read_lut(entry.luts->checked_table(entry.name, entry.entry->value), *entry.entry, parts); });
    return lut;
}

// One LUT, or two of a material that has both polarisations; none if there are mistakes.
std::vector<PlannedLut> luts_of(const LutEntry& entry, const SceneParts& parts) {
    std::optional<PlannedLut> read = read_entry(entry, parts);
    if (!read) return {};
    PlannedLut& lut = *read;
    Effects& effects = lut.job.material.mechanism.effects;
    if (!effects.both_polarisations) return {std::move(lut)};
    effects.both_polarisations = false;
    std::vector<PlannedLut> luts;
    for (const auto& [suffix, polarisation] : polarised) {
        lut.name = entry.name + std::string(suffix);
        effects.polarisation = polarisation;
        luts.push_back(lut);
    }
    return luts;
}

// Whether a name may be that of the entry's LUT, or of one of its two polarisations.
bool may_be(const LutEntry& entry, const std::string& name) {
    if (name == entry.name) return true;
    for (const auto& [suffix, polarisation] : polarised) {
        if (name == entry.name + std::string(suffix)) return true;
    }
    return false;
}

bool is_wanted(const LutEntry& entry, const PlanRequest& request) {
    if (request.wants(entry.name)) return true;
    for (const auto& [suffix, polarisation] : polarised) {
        if (request.wants(entry.name + std::string(suffix))) return true;
    }
    return false;
}

}  // namespace

PlannedLuts plan_luts(const SceneParts& parts, const PlanRequest& request) {
    PlannedLuts planned;
    for (const LutEntry& entry : lut_entries(parts)) {
        if (!is_wanted(entry, request)) {
            planned.names.push_back(entry.name);
            continue;
        }
        std::vector<PlannedLut> luts = luts_of(entry, parts);
        if (luts.empty()) planned.names.push_back(entry.name);
        for (PlannedLut& lut : luts) {
            planned.names.push_back(lut.name);
            if (request.wants(entry.name) || request.wants(lut.name)) planned.luts.push_back(std::move(lut));
        }
    }
    return planned;
}

NamedLut lut_named(const SceneParts& parts, const std::string& name) {
    for (const LutEntry& entry : lut_entries(parts)) {
        if (!may_be(entry, name)) continue;
        std::vector<PlannedLut> luts = luts_of(entry, parts);
        if (luts.empty()) return {true, {}};
        for (PlannedLut& lut : luts) {
            if (lut.name == name) return {true, std::move(lut)};
        }
    }
    return {};
}

}  // namespace nacre
