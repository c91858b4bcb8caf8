#pragma once

#include "nacre/swatch/lit_picture.h"
#include "nacre/swatch/lit_table.h"

namespace nacre {

/// A disc of radius 1 around (0, 0, 0) that lies flat, with the zones of a compact disc (IEC 60908): a hole, clear
/// plastic, plain metal, circular grooves, and a clear edge. Lamps nearby make spokes, along which the colours of the
/// orders follow each other; between them the metal mirrors the studio.
/// @pre the material is a grating
Seen look_at_disc(const LitTable& table, const Ray& ray);

/// From above, at an angle.
Camera disc_camera();

/// Radii, as fractions of the disc's 60 mm.
inline constexpr double disc_hole = 7.5 / 60.0;
inline constexpr double disc_metal_from = 19.0 / 60.0;
inline constexpr double disc_grooves_from = 23.0 / 60.0;
inline constexpr double disc_grooves_to = 58.5 / 60.0;

}  // namespace nacre
