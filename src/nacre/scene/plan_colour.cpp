// [colour]: names only. Whoever plans the scene opens the OpenColorIO config and looks them up in it.
#include "nacre/lut/colour_settings.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {

ColourSettings plan_colour(const Table& scene) {
    ColourSettings colour;
    const Table* table = scene.table("colour");
    if (table == nullptr) return colour;
    if (const Value* config = table->find("config")) {
        colour.config = table->checked_text("config", *config);
        colour.config_where = config->where;
        if (colour.config.empty()) table->fail(config->where, "config is empty; name a file, or leave the key out");
    }
    colour.space_where = table->where();
    if (const Value* space = table->find("space")) {
        colour.space = table->checked_text("space", *space);
        colour.is_space_given = true;
        colour.space_where = space->where;
    }
    colour.gamut = read_word(*table, "gamut", "gamut", gamut_words);
    colour.interchange = table->text_or("interchange", "");
    table->expect_all_read();
    return colour;
}

}  // namespace nacre
