#pragma once

#include <array>
#include <optional>
#include <string>

#include "nacre/optics/base.h"
#include "nacre/scene/scene_context.h"
#include "nacre/scene/table.h"

namespace nacre {

/// What the key `base` of a material says; nothing if it is "black" or missing.
///
/// A number; { rgb }; { spectrum }, of a file; { wavelength_nm, reflectance }; { pigment, scattering_per_um, share };
/// { metal }. Throws Error for anything else.
std::optional<Base> read_base(const Table& table, const SceneContext& context);

/// As a value in TOML; reads back as the same base.
std::string base_toml(const Base& base);

/// The smooth reflectance for a colour.
struct Upsampled {
    RgbBase base;
    double ciede2000 = 0.0;  ///< between its colour and the one that was asked for
};

/// Finds the reflectance whose colour under D65, adapted to the white of Rec.709 and seen by the CIE 1931 observer, is
/// the given one (Jakob and Hanika 2019; in place of their tables, Levenberg and Marquardt's method from grey to the
/// colour in small steps). The same colour gives the same bits.
///
/// Accuracy: every component of XYZ within 1e-10 (`RgbBase.HasTheColourThatItWasMadeFor`), on the faces and corners of
/// the cube, too; of nearly pure colours a hundred thousand times darker than white, within 1e-7.
/// @param rgb  linear Rec.709, each in [0, 1]
Upsampled upsampled(const std::array<double, 3>& rgb);

/// The largest absorption index over a range, by whole nanometres from its first and at its last.
double largest_k(const Index& index, double first_nm, double last_nm);

/// Up to this k a medium counts as clear: glass has 1e-8, which nobody sees in what is thinner than a window.
inline constexpr double transparent_k = 1e-6;

}  // namespace nacre
