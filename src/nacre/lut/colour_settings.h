#pragma once

#include <string>

#include "nacre/base/where.h"
#include "nacre/lut/gamut.h"

namespace nacre {

/// The colour space that a LUT is written in, and what happens to colours outside it.
struct LutColour {
    std::string space = "lin_rec709";
    bool is_space_given = false;  ///< else whoever opens the config decides: see pipeline/loaded_scene.cpp
    Gamut gamut = Gamut::keep;
    std::string where;  ///< what asked for it, for messages: "scene.toml:5:9 [colour]"; empty: it is the default
};

/// Which OpenColorIO config, and the space and gamut of LUTs that name none of their own. The config itself is opened
/// by the front end.
struct ColourSettings : LutColour {
    std::string config;  ///< file as the scene names it; empty: $OCIO, else ours
    Where config_where;
    std::string interchange;       ///< a space of the config that is CIE XYZ D65; empty: by its roles
    std::string aces_interchange;  ///< one that is ACES2065-1. Only one of the two is given
};

}  // namespace nacre
