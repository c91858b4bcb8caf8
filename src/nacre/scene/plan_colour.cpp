// [colour]: names only. Whoever plans the scene opens the OpenColorIO config and looks them up in it.
#include <string>
#include <string_view>

#include "nacre/lut/colour_settings.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {

namespace {

std::string place_in(const Table& table, const Where& where) {
    return where.text() + " [" + table.path() + "]";
}

// The text behind a key.
void read_name(const Table& table, std::string_view key, const Value& value, std::string& name) {
    attempt(table, value.where, [&] {
        name = table.checked_text(key, value);
        if (name.empty()) table.fail(value.where, std::string(key) + " is empty; give a name, or remove the key");
    });
}

// Where XYZ gets into the config: by one key or the other.
void read_interchange(const Table& table, ColourSettings& colour) {
    const Value* xyz = table.find("interchange");
    const Value* aces = table.find("aces_interchange");
    if (xyz != nullptr) read_name(table, "interchange", *xyz, colour.interchange);
    if (aces != nullptr) read_name(table, "aces_interchange", *aces, colour.aces_interchange);
    if (xyz == nullptr || aces == nullptr) return;
    attempt(table, aces->where, [&] {
        table.fail(aces->where,
                   "interchange and aces_interchange are both given; keep the one that names a space of "
                   "the config: interchange for CIE XYZ D65, aces_interchange for ACES2065-1");
    });
}

}  // namespace

void read_lut_colour(const Table& table, LutColour& colour) {
    const Value* space = table.find("space");
    const Value* gamut = table.find("gamut");
    if (gamut != nullptr) {
        colour.gamut = read_word(table, "gamut", "gamut", gamut_words);
        colour.where = place_in(table, gamut->where);
    }
    if (space != nullptr) {
        read_name(table, "space", *space, colour.space);
        colour.is_space_given = true;
        colour.where = place_in(table, space->where);
    }
}

ColourSettings plan_colour(const Table& scene) {
    ColourSettings colour;
    attempt(scene, scene.where(), [&] {
        const Table* table = scene.table("colour");
        if (table == nullptr) return;
        colour.where = place_in(*table, table->where());
        if (const Value* config = table->find("config")) {
            read_name(*table, "config", *config, colour.config);
            colour.config_where = config->where;
        }
        read_lut_colour(*table, colour);
        read_interchange(*table, colour);
        table->expect_all_read();
    });
    return colour;
}

}  // namespace nacre
