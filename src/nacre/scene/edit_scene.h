#pragma once

#include <string>

#include "nacre/scene/table.h"

namespace nacre {

/// One value of a scene that is changed before the scene is planned: of --set, or of a row of variants.
struct SceneEdit {
    std::string key;  ///< the way to it: "material.hero.picks[0].colour"; names with dots are in quotes
    Value value;
    Where where;  ///< what asks for it: "--set ...", or a line of a file
};

/// Changes or adds one value of a scene.
///
/// The last name of the key may be new: whether a key is known there is found when the scene is planned. What stands
/// before it has to exist, but [light], [colour], [accuracy] and [accuracy.sampling] are added where they are missing.
/// @param scene  the top table, includes resolved; shares no table with another scene
/// @throws SceneError with the edit's place
void set_key(Table& scene, const SceneEdit& edit);

/// "material.hero.picks[0].colour = "#aa2244"", in TOML: for headers.
std::string edit_text(const SceneEdit& edit);

/// A scene with the same content that nobody has read yet and that shares no table with this one.
/// @param without  a key at the top that is left out
Table copy_of(const Table& scene, std::string_view without);

}  // namespace nacre
