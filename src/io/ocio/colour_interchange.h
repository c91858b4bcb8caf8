#pragma once

#include <string>

#include "io/ocio/ocio_detail.h"
#include "io/ocio/opened_config.h"

namespace nacre {

/// The interchange space of a config, where CIE XYZ D65 enters; colour_config.h lists the order of preference.
struct Interchange {
    std::string space;       ///< of the config
    std::string how;         ///< for messages: `role "aces_interchange" ("ACES2065-1")`
    bool takes_ap0 = false;  ///< the space is ACES2065-1, not XYZ
    OCIO::ReferenceSpaceType leads_to =
        OCIO::REFERENCE_SPACE_SCENE;  ///< the side for which it is the interchange space
    bool confirmed = false;           ///< a well-known space of the config agrees with ours behind it
};

/// The interchange space for targets of that side, checked against the well-known spaces behind it (see
/// colour_config.h).
/// @throws Error if there is none, if its path has a view transform that is not a matrix, or if it is wrong
Interchange find_interchange(const OpenedConfig& opened, OCIO::ReferenceSpaceType side, const std::string& where);

/// XYZ D65 -> interchange -> `last`, whose source is interchange.space.
OCIO::GroupTransformRcPtr path_through(const Interchange& interchange, const OCIO::TransformRcPtr& last);
/// XYZ D65 -> interchange -> a colour space.
OCIO::GroupTransformRcPtr path_to_space(const Interchange& interchange, const std::string& space);

/// White and 18 % grey must be neutral within 1e-3 at the end of the path.
/// @throws Error naming the space that they were converted to
void check_neutral(const OpenedConfig& opened, const Interchange& interchange, const Conversion& conversion,
                   const std::string& space, const std::string& where);

}  // namespace nacre
