#pragma once

#include <string>

#include "nacre/base/where.h"
#include "nacre/lut/gamut.h"

namespace nacre {

/// Which OpenColorIO config, space and gamut. The config itself is opened by the front end.
struct ColourSettings {
    std::string config;  ///< file as the scene names it; empty: $OCIO, else ours
    Where config_where;
    std::string space = "lin_rec709";
    bool is_space_given = false;  ///< else the front end looks for linear Rec.709 by its other names too
    Where space_where;
    Gamut gamut = Gamut::keep;
    std::string interchange;
};

}  // namespace nacre
