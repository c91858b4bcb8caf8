// [material]: each material is read when a LUT or a swatch names it first, and checked with the scene's light.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/lut/sampler.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {
namespace {

const Table* material_table(const Table& scene) {
    const Table* materials = nullptr;
    if (!attempt(scene, scene.where(), [&] { materials = scene.table("material"); })) return nullptr;
    if (materials != nullptr && !materials->entries().empty()) return materials;
    scene.note_missing("material", "a scene needs a [material.NAME]");
    return nullptr;
}

}  // namespace

void check_fringes(const Table& table, const Mechanism& mechanism, const LightSettings& light) {
    const double fringes = fringe_count(mechanism, light);
    if (fringes <= most_fringes) return;
    table.note(table.where(), "the layers are so thick that " + significant_text(fringes, 3) +
                                  " fringes lie in range_nm; at most " + number_text(most_fringes) +
                                  " are allowed; in a stack, mark thick layers with incoherent = true");
}

Materials::Materials(const Table& scene, SceneContext context, std::shared_ptr<const Light> light, bool any_thickness)
    : table_(material_table(scene)),
      context_(std::move(context)),
      light_(std::move(light)),
      any_thickness_(any_thickness) {
    if (table_ == nullptr) return;
    for (const Table::Entry& entry : table_->entries()) {
        check_name(entry.key, *table_, entry.key_where);
        names_.push_back(entry.key);
    }
}

const SceneMaterial* Materials::named(const std::string& name) {
    const auto [found, is_new] = read_.try_emplace(name);
    if (is_new) found->second = read_material(name);
    return found->second ? &*found->second : nullptr;
}

std::optional<SceneMaterial> Materials::read_material(const std::string& name) {
    const auto& entries = table_->entries();
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == name; });
    std::optional<ReadMechanism> read;
    attempt(*table_, entry->key_where, [&] {
        const Table& table = table_->checked_table(entry->key, entry->value);
        ReadMechanism all = read_mechanism(table, context_);
        table.expect_all_read();
        if (light_ != nullptr && !any_thickness_ && table.is_good())
            check_fringes(table, all.mechanism, light_->settings);
        if (table.is_good()) read = std::move(all);
    });
    if (!read) return {};
    if (read->search) {
        searches_.push_back(std::move(*read->search));
        searches_.back().material = name;
    }
    return SceneMaterial{{name, std::move(read->mechanism), entry->key_where},
                         std::move(read->picked),
                         std::move(read->shape_fit),
                         std::move(read->pale_paths)};
}

std::vector<SceneMaterial> Materials::read() const {
    std::vector<SceneMaterial> materials;
    for (const std::string& name : names_) {
        const auto found = read_.find(name);
        if (found != read_.end() && found->second) materials.push_back(*found->second);
    }
    return materials;
}

const SceneMaterial* material_of(const Table& table, Materials& materials) {
    const Value* value = table.find("material");
    const std::vector<std::string>& known = materials.names();
    if (known.empty()) return nullptr;
    if (value == nullptr) {
        if (known.size() == 1) return materials.named(known.front());
        table.note(table.where(), "material is missing, and the scene has " + std::to_string(known.size()) +
                                      " materials; name one of them: " + known_like("", known));
        return nullptr;
    }
    std::string name;
    if (!attempt(table, value->where, [&] { name = table.checked_text("material", *value); })) return nullptr;
    if (std::find(known.begin(), known.end(), name) != known.end()) return materials.named(name);
    table.note(value->where, "unknown material " + in_quotes(name) + "; known: " + known_like(name, known));
    return nullptr;
}

}  // namespace nacre
