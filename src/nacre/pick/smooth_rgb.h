#pragma once

#include <array>

#include "nacre/optics/base.h"

namespace nacre {

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
/// @param rgb       linear Rec.709, each in [0, 1]
/// @param stations  the steps from grey to the colour; with fewer, the method may end before it, as ciede2000 says
Upsampled upsampled(const std::array<double, 3>& rgb, int stations = 16);

}  // namespace nacre
