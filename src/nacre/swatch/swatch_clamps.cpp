#include "nacre/swatch/swatch_clamps.h"

#include <variant>

#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/swatch/swatch_layout.h"

namespace nacre {

std::vector<ClampedRange> clamped_ranges(const Material& material) {
    std::vector<ClampedRange> ranges;
    const auto* palette = std::get_if<Palette>(&material.mechanism);
    if (palette == nullptr) return ranges;
    const auto add = [&](double bound_deg, double end_deg) {
        const Lobe lobe = palette_lobe_unclamped(*palette, Incidence::from_degrees(bound_deg));
        const std::string what = lobe.height > 1.0                  ? "height reaches 1"
                                 : lobe.height < 0.0                ? "height reaches 0"
                                 : lobe.width_nm < 0.0              ? "width reaches 0"
                                 : lobe.floor > 1.0                 ? "floor reaches 1"
                                 : lobe.floor < 0.0                 ? "floor reaches 0"
                                 : lobe.flatness > largest_flatness ? "flatness reaches 1"
                                                                    : "flatness reaches 0";
        ranges.push_back({bound_deg, end_deg, what + " at " + rounded_text(bound_deg) + "°"});
    };
    const ClampBounds bounds = palette_clamp_bounds(*palette);
    if (bounds.below_deg) add(*bounds.below_deg, 0.0);
    if (bounds.above_deg) add(*bounds.above_deg, 90.0);
    return ranges;
}

}  // namespace nacre
