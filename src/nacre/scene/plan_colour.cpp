// [colour]: names only. Whoever plans the scene opens the OpenColorIO config and looks them up in it.
#include <string>
#include <string_view>

#include "nacre/lut/colour_settings.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {

namespace {

// The text behind a key, and its place.
void read_name(const Table& table, std::string_view key, std::string& name, Where& where) {
    const Value* value = table.find(key);
    if (value == nullptr) return;
    attempt(table, value->where, [&] {
        name = table.checked_text(key, *value);
        where = value->where;
        if (name.empty()) table.fail(value->where, std::string(key) + " is empty; give a name, or remove the key");
    });
}

}  // namespace

ColourSettings plan_colour(const Table& scene) {
    ColourSettings colour;
    attempt(scene, scene.where(), [&] {
        const Table* table = scene.table("colour");
        if (table == nullptr) return;
        read_name(*table, "config", colour.config, colour.config_where);
        colour.space_where = table->where();
        colour.is_space_given = table->find("space") != nullptr;
        read_name(*table, "space", colour.space, colour.space_where);
        colour.gamut = read_word(*table, "gamut", "gamut", gamut_words);
        attempt(*table, table->where(), [&] { colour.interchange = table->text_or("interchange", ""); });
        table->expect_all_read();
    });
    return colour;
}

}  // namespace nacre
