#include <algorithm>

#include "nacre/base/names.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/shade/integral.h"

namespace nacre {
namespace {

constexpr Allowed allowed_wavelengths{2, 10000};
constexpr Allowed allowed_nodes{8, most_nodes};
constexpr Allowed allowed_realisations{2, 16384};
constexpr Allowed allowed_directions{2, 256};
constexpr Allowed allowed_radii{2, 4096};
constexpr Allowed allowed_slices{4, 1024};

// One number, or one per band of angles.
NodeCounts read_nodes(const Table& table, const Value& value) {
    NodeCounts counts{};
    if (!std::holds_alternative<Value::Array>(value.data)) {
        counts.fill(table.checked_integer("nodes", value, allowed_nodes));
        return counts;
    }
    const Value::Array& list = table.checked_array("nodes", value);
    if (list.size() != counts.size()) {
        table.fail(value.where, "nodes has " + std::to_string(list.size()) + " numbers; give one, or " +
                                    std::to_string(counts.size()) +
                                    ": for angles up to 72.5, 87.1, 89.8 and 90 degrees");
    }
    for (std::size_t band = 0; band < counts.size(); ++band)
        counts[band] = table.checked_integer("nodes", list[band], allowed_nodes);
    return counts;
}

// Which effects are simulated, and how finely those are that are integrals.
void read_effect_wishes(const Table& table, AccuracySettings& accuracy) {
    if (const Value* effects = table.find("effects")) {
        const std::string& word = table.checked_text("effects", *effects);
        if (word != "auto" && word != "all")
            table.fail(effects->where, "unknown effects " + in_quotes(word) + "; known: auto, all");
        accuracy.may_drop_effects = word == "auto";
    }
    std::vector<std::string> known;
    for (const EffectRow& row : effect_rows()) known.emplace_back(row.name);
    for (const std::string& name : table.texts("without")) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end())
            table.fail_at("without", "unknown effect " + in_quotes(name) + "; known: " + comma_separated(known));
        accuracy.without.insert(static_cast<Effect>(found - known.begin()));
    }
    accuracy.points.hemisphere = table.integer_or("base_directions", allowed_directions, 0);
    accuracy.points.sizes = table.integer_or("radii", allowed_radii, 0);
    if (const Value* slices = table.find("slices")) {
        accuracy.points.slices = table.checked_integer("slices", *slices, allowed_slices);
        if (accuracy.points.slices % 4 != 0) table.fail(slices->where, "slices come in fours; give 4, 8, 12, ...");
    }
}

}  // namespace

AccuracySettings read_accuracy(const Table* table) {
    if (table == nullptr) return {};
    AccuracySettings accuracy;
    if (const Value* bound = table->find("max_de00"))
        accuracy.max_de00 = table->checked_number("max_de00", *bound, allowed_max_de00);
    if (const Value* nodes = table->find("wavelengths"))
        accuracy.wavelengths = table->checked_integer("wavelengths", *nodes, allowed_wavelengths);
    if (const Value* integral = table->find("integral")) {
        accuracy.integral =
            meaning_of(integral_words, "integral", table->checked_text("integral", *integral), *table, integral->where);
        if (accuracy.wavelengths) {
            table->fail(integral->where,
                        "integral says how to do without wavelengths, and wavelengths is given; leave one of them out");
        }
    }
    if (const Value* nodes = table->find("nodes")) accuracy.nodes = read_nodes(*table, *nodes);
    if (accuracy.nodes && accuracy.wavelengths) {
        table->fail_at("nodes", "nodes and wavelengths both say where spectra are sampled; leave one of them out");
    }
    if (const Value* realisations = table->find("realisations")) {
        accuracy.realisations = table->checked_integer("realisations", *realisations, allowed_realisations);
        if (*accuracy.realisations % 2 != 0)
            table->fail(realisations->where, "realisations come in pairs; give an even number");
    }
    read_effect_wishes(*table, accuracy);
    accuracy.size = read_lut_size(*table);
    table->expect_all_read();
    return accuracy;
}

}  // namespace nacre
