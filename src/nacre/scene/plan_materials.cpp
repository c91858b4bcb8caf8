#include <algorithm>
#include <utility>

#include "nacre/base/names.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {

Materials::Materials(const Table& table, SceneContext context, Check check)
    : table_(table), context_(std::move(context)), check_(std::move(check)) {
    context_.note_picked = [this](const PickedColour& picked) { picked_.push_back(picked); };
    context_.note_found = [this](const MechanismSearch& search, const std::vector<FoundMechanism>& found) {
        searches_.push_back({"", search, found});
    };
    context_.note_shape = [this](const ShapeFit& fit) { shape_fit_ = fit; };
    for (const Table::Entry& entry : table.entries()) {
        check_name(entry.key, table, entry.key_where);
        names_.push_back(entry.key);
    }
}

const SceneMaterial& Materials::named(const std::string& name) {
    const auto found = read_.find(name);
    if (found != read_.end()) return found->second;
    const auto& entries = table_.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == name; });
    const Table& table = table_.checked_table(entry->key, entry->value);
    picked_.clear();
    const std::size_t searches = searches_.size();
    shape_fit_.reset();
    SceneMaterial material{{entry->key, read_mechanism(table, context_), entry->key_where}, {}, {}};
    for (std::size_t i = searches; i < searches_.size(); ++i) searches_[i].material = entry->key;
    material.picked = std::exchange(picked_, {});
    material.shape_fit = std::exchange(shape_fit_, {});
    table.expect_all_read();
    check_(table, material.mechanism);
    return read_.emplace(name, std::move(material)).first->second;
}

std::vector<SceneMaterial> Materials::read() const {
    std::vector<SceneMaterial> materials;
    for (const std::string& name : names_) {
        const auto found = read_.find(name);
        if (found != read_.end()) materials.push_back(found->second);
    }
    return materials;
}

const SceneMaterial& material_of(const Table& table, Materials& materials) {
    const Value* value = table.find("material");
    const std::vector<std::string>& known = materials.names();
    if (value == nullptr) {
        if (known.size() == 1) return materials.named(known.front());
        table.fail(table.where(),
                   "material is missing, and the scene has " + std::to_string(known.size()) + "; say which");
    }
    const std::string& name = table.checked_text("material", *value);
    if (std::find(known.begin(), known.end(), name) != known.end()) return materials.named(name);
    table.fail(value->where, "unknown material " + in_quotes(name) + "; known: " + known_like(name, known));
}

}  // namespace nacre
