#include <algorithm>

#include "nacre/base/names.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {
namespace {

constexpr Allowed allowed_wavelengths{2, 10000};
constexpr Allowed allowed_nodes{8, most_nodes};
constexpr Allowed allowed_thickness_samples{2, 16384};
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

// Which effects are simulated.
void read_effect_requests(const Table& table, AccuracySettings& accuracy) {
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
}

// One of the counts in [accuracy.sampling]. Until version 0.2 the scene may say it in [accuracy], under its old key.
struct Count {
    const Table* table = nullptr;  // null: the scene does not say it
    std::string key;
    const Value* value = nullptr;
};

bool has_key(const Table& table, std::string_view key) {
    return std::any_of(table.entries().begin(), table.entries().end(),
                       [&](const Table::Entry& entry) { return entry.key == key; });
}

std::string place_of(const Table& table, std::string_view key) {
    for (const Table::Entry& entry : table.entries()) {
        if (entry.key == key) return entry.key_where.text() + " [" + table.path() + "]: ";
    }
    return {};
}

Count find_count(const Table& accuracy, const Table* sampling, const std::string& key, const std::string& old_key,
                 std::vector<std::string>& warnings) {
    const Value* value = sampling != nullptr ? sampling->find(key) : nullptr;
    const bool has_old = has_key(accuracy, old_key);  // asked for so, an old key is not proposed for a misspelling
    if (value != nullptr && has_old)
        accuracy.fail_at(old_key,
                         old_key + " is also given as " + key + " in [accuracy.sampling]; leave out one of them");
    if (value != nullptr) return {sampling, key, value};
    if (!has_old) return {};
    warnings.push_back(place_of(accuracy, old_key) + "the key " + old_key + " is now " +
                       (key == old_key ? "" : key + ", ") +
                       "in the table [accuracy.sampling]; a later version will not read it here");
    return {&accuracy, old_key, accuracy.find(old_key)};
}

// @param step  counts come in multiples of this
int read_count(const Count& count, const Allowed& allowed, int step) {
    if (count.table == nullptr) return 0;
    const int number = count.table->checked_integer(count.key, *count.value, allowed);
    if (number % step == 0) return number;
    count.table->fail(count.value->where, count.key + " = " + std::to_string(number) + " is not a multiple of " +
                                              std::to_string(step) + "; give " + std::to_string(step) + ", " +
                                              std::to_string(2 * step) + ", " + std::to_string(3 * step) + " ...");
}

SamplingCounts read_sampling(const Table& accuracy, std::vector<std::string>& warnings) {
    const Table* sampling = accuracy.table("sampling");
    const auto count = [&](const std::string& key, const std::string& old_key) {
        return find_count(accuracy, sampling, key, old_key, warnings);
    };
    SamplingCounts counts;
    if (const Count nodes = count("nodes", "nodes"); nodes.table != nullptr) {
        counts.nodes = read_nodes(*nodes.table, *nodes.value);
        if (has_key(accuracy, "wavelengths")) {
            nodes.table->fail_at("nodes",
                                 "nodes and wavelengths both say where spectra are sampled; leave one of them out");
        }
    }
    // Samples come in pairs, one as much thicker as the other is thinner; slices in fours, see optics/crystal.h.
    counts.thickness_samples = read_count(count("thickness_samples", "realisations"), allowed_thickness_samples, 2);
    counts.base_directions = read_count(count("base_directions", "base_directions"), allowed_directions, 1);
    counts.radii = read_count(count("radii", "radii"), allowed_radii, 1);
    counts.slices = read_count(count("slices", "slices"), allowed_slices, 4);
    if (sampling != nullptr) sampling->expect_all_read();
    return counts;
}

void warn_of_integral(const Table& table, std::vector<std::string>& warnings) {
    if (!has_key(table, "integral")) return;
    table.find("integral");
    warnings.push_back(place_of(table, "integral") +
                       "the key integral has no effect any more, because the band of a palette is always integrated "
                       "exactly; leave it out");
}

}  // namespace

AccuracySettings read_accuracy(const Table* table) {
    if (table == nullptr) return {};
    AccuracySettings accuracy;
    if (const Value* bound = table->find("max_de00"))
        accuracy.max_de00 = table->checked_number("max_de00", *bound, allowed_max_de00);
    if (const Value* nodes = table->find("wavelengths"))
        accuracy.wavelengths = table->checked_integer("wavelengths", *nodes, allowed_wavelengths);
    warn_of_integral(*table, accuracy.warnings);
    accuracy.sampling = read_sampling(*table, accuracy.warnings);
    read_effect_requests(*table, accuracy);
    accuracy.size = read_lut_size(*table);
    table->expect_all_read();
    return accuracy;
}

}  // namespace nacre
