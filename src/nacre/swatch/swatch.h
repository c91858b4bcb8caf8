#pragma once

#include <memory>
#include <vector>

#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// The images that a swatch of a material is made of: a swatch is a bake, not a second renderer.
///
/// plane: peak wavelength (x) against angle (y). palette: width (x) against height (y), one job per pick, at the pick's
/// angle and with that pick as its material's only one. strip, sphere and picks: the default LUT, finely
/// sampled.
std::vector<Job> swatch_jobs(SwatchKind kind, const Material& material, const std::shared_ptr<const Light>& light);

/// Lays the picture out and bakes what it shows, at the picture's own resolution: the sizes of the jobs do not matter.
///
/// Angles, widths and heights grow upwards and to the right, but a LUT's angle runs as its axis does. A palette of more
/// than `most_palette_panels` picks shows the first of them, and says so.
/// @param space  of the scene's LUTs: a strip, and a LUT with two axes, shows where it leaves that
/// @pre swatch.jobs is not empty, and for plane and palette they are those of swatch_jobs()
Swatch draw_swatch(const PlannedSwatch& swatch, const LutSpace& space = {});

inline constexpr std::size_t most_palette_panels = 12;

}  // namespace nacre
