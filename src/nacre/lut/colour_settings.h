#pragma once

#include <string>

#include "nacre/base/where.h"
#include "nacre/lut/gamut.h"

namespace nacre {

/// The colour space that a LUT is written in, and what happens to colours outside it.
struct LutColour {
    std::string space = "lin_rec709";
    bool is_space_given = false;  ///< else the front end looks for linear Rec.709 by its other names too
    Gamut gamut = Gamut::keep;
    std::string where;  ///< what asked for it, for messages: "scene.toml:5:9 [colour]"; empty: it is the default
};

/// Which OpenColorIO config, and the space and gamut of LUTs that name none of their own. The config itself is opened
/// by the front end.
struct ColourSettings : LutColour {
    std::string config;  ///< file as the scene names it; empty: $OCIO, else ours
    Where config_where;
    std::string interchange;
};

}  // namespace nacre
