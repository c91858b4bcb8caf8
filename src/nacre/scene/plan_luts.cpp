// [lut]: which LUTs a scene has, and under which names. read_lut() reads one of them (plan_lut.cpp).
//
// A scene without [lut] has one per material, with all defaults. A material with polarisation = "both" makes two of
// each of its LUTs, NAME_s and NAME_p, and a LUT with quantity = "both" is two, NAME_r and NAME_t; with both there are
// four, NAME_s_r and so on. This is known only once the material is read. So a LUT that nobody wants keeps its own name
// among PlannedLuts::names, where it can be asked for as NAME or by any of these names.
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
constexpr std::pair<std::string_view, Observed> quantities[] = {{"_r", Observed::reflectance},
                                                                {"_t", Observed::transmittance}};

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
    lut.name = lut.entry = name;
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

// One LUT, or those that it becomes; none if there are mistakes. The two of a pair stand side by side.
std::vector<PlannedLut> luts_of(const LutEntry& entry, const SceneParts& parts) {
    std::optional<PlannedLut> read = read_entry(entry, parts);
    if (!read) return {};
    std::vector<PlannedLut> luts{std::move(*read)};
    const auto split = [&](const auto& kinds, auto Effects::*number) {
        std::vector<PlannedLut> all;
        for (const PlannedLut& lut : luts) {
            for (const auto& [suffix, kind] : kinds) {
                PlannedLut& next = all.emplace_back(lut);
                next.name += suffix;
                next.job.material.mechanism.effects.*number = kind;
            }
        }
        luts = std::move(all);
    };
    bool& both_polarisations = luts.front().job.material.mechanism.effects.both_polarisations;
    if (std::exchange(both_polarisations, false)) split(polarised, &Effects::polarisation);
    if (luts.front().is_of_pair) split(quantities, &Effects::observed);
    return luts;
}

// Whether some name is that of the entry, or one that its LUTs may have.
template <typename IsIt>
bool any_name(const LutEntry& entry, const IsIt& is_it) {
    for (const std::string_view of_light : {"", "_s", "_p"}) {
        for (const std::string_view of_observed : {"", "_r", "_t"}) {
            if (is_it(entry.name + std::string(of_light) + std::string(of_observed))) return true;
        }
    }
    return false;
}

}  // namespace

PlannedLuts plan_luts(const SceneParts& parts, const PlanRequest& request) {
    PlannedLuts planned;
    for (const LutEntry& entry : lut_entries(parts)) {
        if (!any_name(entry, [&](const std::string& name) { return request.wants(name); })) {
            planned.names.push_back(entry.name);
            continue;
        }
        std::vector<PlannedLut> luts = luts_of(entry, parts);
        if (luts.empty()) planned.names.push_back(entry.name);
        for (PlannedLut& lut : luts) {
            planned.names.push_back(lut.name);
            const std::string of_pair = lut.is_of_pair ? lut.name.substr(0, lut.name.size() - 2) : lut.name;
            if (request.wants(entry.name) || request.wants(of_pair) || request.wants(lut.name))
                planned.luts.push_back(std::move(lut));
        }
    }
    return planned;
}

NamedLut lut_named(const SceneParts& parts, const std::string& name) {
    for (const LutEntry& entry : lut_entries(parts)) {
        if (!any_name(entry, [&](const std::string& one) { return one == name; })) continue;
        std::vector<PlannedLut> luts = luts_of(entry, parts);
        if (luts.empty()) return {true, {}};
        for (PlannedLut& lut : luts) {
            if (lut.name == name) return {true, std::move(lut)};
        }
    }
    return {};
}

}  // namespace nacre
