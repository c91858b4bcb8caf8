#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/ocio/ocio_detail.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// configs/ocio/config.ocio, compiled in (nacre_embed_text).
extern const std::string_view builtin_ocio_config;

/// Our config, parsed once.
const OCIO::ConstConfigRcPtr& builtin_config();

/// The colours by which two conversions are compared: primaries of Rec.709 at full, a mix, white and 18 % grey.
///
/// They are saturated, because a wrong matrix may map white to white, and lie inside every known gamut.
inline constexpr std::size_t probe_count = 6;
inline constexpr std::size_t first_neutral_probe = 4;  ///< white; 18 % grey follows
const Image<Xyz>& probe_colours();

/// Largest difference of any component over the probes.
double largest_difference(const Image<Rgb>& a, const Image<Rgb>& b);

/// A space of our own config and where it takes the probes: the reference for other configs.
struct KnownSpace {
    std::vector<std::string> names;  ///< its name, its aliases, then the names that older configs have for it
    std::string interop_id;          ///< Color Interop Forum's, "" where there is none
    OCIO::ReferenceSpaceType side;
    bool linear;
    Image<Rgb> probes;
};
const std::vector<KnownSpace>& known_spaces();

/// Whether the target is CIE XYZ D65 itself: the probes come out as they went in, within 1e-4.
bool changes_nothing(const Conversion& conversion);

/// The id of the known space of that side that takes the probes to the same colours within 1e-4, or "".
std::string interop_id_of(const Conversion& conversion, OCIO::ReferenceSpaceType side);

}  // namespace nacre
