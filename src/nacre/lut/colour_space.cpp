#include "nacre/lut/colour_space.h"

namespace nacre {

Rgb ColourSpace::to_rgb(Xyz colour) const {
    return to_rgb(Image<Xyz>(1, 1, colour)).at(0, 0);
}

std::optional<RgbPrimaries> ColourSpace::primaries() const {
    auto primaries = primaries_by_interop_id(interop_id());
    if (!primaries && linear_matrix()) primaries = primaries_of(*linear_matrix());
    return primaries;
}

}  // namespace nacre
