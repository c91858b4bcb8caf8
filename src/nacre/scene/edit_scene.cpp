#include "nacre/scene/edit_scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/key_names.h"

namespace nacre {
namespace {

// Tables whose keys all have defaults, so that a scene may do without the table.
constexpr std::array optional_tables{"light", "colour", "accuracy", "accuracy.sampling"};

// One step on the way to a value: a name in a table, or a place in an array.
struct Step {
    std::string name;  // empty: a place
    std::size_t place = 0;

    std::string text() const { return name.empty() ? "[" + std::to_string(place) + "]" : name; }
};

[[noreturn]] void refuse(const SceneEdit& edit, const std::string& why) {
    throw SceneError(edit.where, edit.where.text() + ": " + why);
}

[[noreturn]] void refuse_key(const SceneEdit& edit) {
    refuse(edit, in_quotes(edit.key) +
                     " is not a key of a scene; write it like material.NAME.picks[0].colour, and a name that has a dot "
                     "in quotes");
}

bool is_bare(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// A bare or quoted name at the start of the text, which is taken off.
Step take_name(std::string_view& rest, const SceneEdit& edit) {
    const bool is_quoted = rest.starts_with('"');
    if (is_quoted) rest.remove_prefix(1);
    std::size_t end = 0;
    while (end < rest.size() && (is_quoted ? rest[end] != '"' : is_bare(rest[end]))) ++end;
    if (end == 0 || (is_quoted && end == rest.size())) refuse_key(edit);
    Step step{std::string(rest.substr(0, end))};
    rest.remove_prefix(end + (is_quoted ? 1 : 0));
    return step;
}

// "[12]" at the start of the text, which is taken off.
Step take_place(std::string_view& rest, const SceneEdit& edit) {
    Step step;
    const char* const end = rest.data() + rest.size();
    const auto [last, failure] = std::from_chars(rest.data() + 1, end, step.place);
    if (failure != std::errc() || last == end || *last != ']') refuse_key(edit);
    rest.remove_prefix(static_cast<std::size_t>(last + 1 - rest.data()));
    return step;
}

std::vector<Step> steps_of(const SceneEdit& edit) {
    std::string_view rest = edit.key;
    std::vector<Step> steps{take_name(rest, edit)};
    while (!rest.empty()) {
        if (rest.front() == '[') {
            steps.push_back(take_place(rest, edit));
        } else if (rest.front() == '.') {
            rest.remove_prefix(1);
            steps.push_back(take_name(rest, edit));
        } else {
            refuse_key(edit);
        }
    }
    return steps;
}

// The way that was walked, and where it has led to.
struct Walk {
    Table& scene;
    const SceneEdit& edit;
    Value* value = nullptr;  // null: the scene itself
    std::string path{};      // as far as it was walked

    std::string place() const { return path + (path.empty() ? "" : " in ") + scene.where().file; }
};

std::string joined(const std::string& path, const Step& step) {
    return path + (path.empty() || step.name.empty() ? "" : ".") + step.text();
}

Table& table_here(const Walk& walk) {
    if (walk.value == nullptr) return walk.scene;
    const auto* table = std::get_if<std::shared_ptr<Table>>(&walk.value->data);
    if (table == nullptr)
        refuse(walk.edit, walk.place() + " is " + std::string(walk.value->kind()) + ", which has no keys");
    return **table;
}

Value& element_here(const Walk& walk, const Step& step) {
    auto* array = walk.value == nullptr ? nullptr : std::get_if<Value::Array>(&walk.value->data);
    if (array == nullptr)
        refuse(walk.edit, walk.place() + " is " + std::string(walk.value->kind()) + ", which has no " + step.text());
    if (step.place >= array->size()) {
        refuse(walk.edit, walk.place() + " has no " + step.text() + "; it has " + std::to_string(array->size()) +
                              (array->size() == 1 ? " element" : " elements") + ", counted from [0]");
    }
    return (*array)[step.place];
}

[[noreturn]] void refuse_missing(const Walk& walk, const Table& table, const Step& step, const std::string& path) {
    const std::string& file = walk.scene.where().file;
    if (path == "lut") {
        refuse(walk.edit, file +
                              " has no [lut.NAME]; add one to the scene, or set accuracy.max_de00, accuracy.size, "
                              "colour.space or colour.gamut, which hold for all LUTs");
    }
    std::vector<std::string> known;
    for (const Table::Entry& entry : table.entries()) known.push_back(entry.key);
    refuse(walk.edit, file + " has no " + path + "; known" + (walk.path.empty() ? "" : " in " + walk.path) + ": " +
                          known_like(step.name, known));
}

Value& entry_here(const Walk& walk, const Step& step) {
    Table& table = table_here(walk);
    if (Value* value = table.to_change(step.name)) return *value;
    const std::string path = joined(walk.path, step);
    const bool is_optional = std::any_of(optional_tables.begin(), optional_tables.end(),
                                         [&](std::string_view optional) { return is_same_key(optional, path); });
    if (!is_optional) refuse_missing(walk, table, step, path);
    table.set(step.name, walk.edit.where, {std::make_shared<Table>(path, walk.edit.where), walk.edit.where});
    return *table.to_change(step.name);
}

Value copied(const Value& value);

void copy_entries(const Table& from, std::string_view without, Table& into) {
    for (const Table::Entry& entry : from.entries()) {
        if (entry.key != without) into.add(entry.key, entry.key_where, copied(entry.value));
    }
}

Value copied(const Value& value) {
    if (const auto* array = std::get_if<Value::Array>(&value.data)) {
        Value::Array elements;
        for (const Value& element : *array) elements.push_back(copied(element));
        return {std::move(elements), value.where};
    }
    if (const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data)) {
        auto copy = std::make_shared<Table>((*table)->path(), (*table)->where());
        copy_entries(**table, {}, *copy);
        return {std::move(copy), value.where};
    }
    return value;
}

std::string key_of(const std::string& name) {
    return std::all_of(name.begin(), name.end(), is_bare) ? name : toml_string(name);
}

std::string toml_of(const Value& value) {
    if (const auto* array = std::get_if<Value::Array>(&value.data)) {
        std::string list;
        for (const Value& element : *array) list += (list.empty() ? "" : ", ") + toml_of(element);
        return "[" + list + "]";
    }
    if (const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data)) {
        std::string list;
        for (const Table::Entry& entry : (*table)->entries())
            list += (list.empty() ? " " : ", ") + key_of(entry.key) + " = " + toml_of(entry.value);
        return "{" + list + " }";
    }
    const auto* text = std::get_if<std::string>(&value.data);
    return text != nullptr ? toml_string(*text) : value.text();
}

}  // namespace

void set_key(Table& scene, const SceneEdit& edit) {
    const std::vector<Step> steps = steps_of(edit);
    if (steps.front().name == "include") refuse(edit, "include cannot be set here; write it in the scene");
    Walk walk{scene, edit};
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        walk.value = steps[i].name.empty() ? &element_here(walk, steps[i]) : &entry_here(walk, steps[i]);
        walk.path = joined(walk.path, steps[i]);
    }
    if (steps.back().name.empty()) {
        element_here(walk, steps.back()) = edit.value;
    } else {
        table_here(walk).set(steps.back().name, edit.where, edit.value);
    }
}

std::string edit_text(const SceneEdit& edit) {
    return edit.key + " = " + toml_of(edit.value);
}

Table copy_of(const Table& scene, std::string_view without) {
    Table copy(scene.path(), scene.where());
    copy_entries(scene, without, copy);
    return copy;
}

}  // namespace nacre
