#pragma once

#include <cstddef>
#include <span>

#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// How far a finished LUT is from the truth.
struct Measured {
    double reached = 0.0;  ///< largest CIEDE2000 found
    LutPoint at;
    double scale = 1.0;  ///< how many times brighter colours were shown, see display_scale()
    Work work;
};

/// Fetches from the stored numbers as a shader does, and compares with Reference, at the points given and at
/// `spread_points` more that lie between the texels all over the LUT, and at its corners. Of models whose every colour
/// takes the reference long (irregular stacks, thick layers, thousands of layers) fewer points are looked at.
/// @param stored    the components as they are in the file
/// @param suspects  where the LUT errs most, by choose_lut()
/// @pre the encoding has a way back to XYZ
Measured measure(const Job& job, const Image<Rgb>& stored, const Encoding& encoding,
                 std::span<const LutPoint> suspects);

inline constexpr int spread_points = 96;

/// What a LUT would lose if its negative components became 0.
struct ClippingLoss {
    std::size_t texels = 0;  ///< whose colour would change by more than the bound
    double de00 = 0.0;       ///< the largest change, CIEDE2000
    friend bool operator==(const ClippingLoss&, const ClippingLoss&) = default;
};

/// @param stored  the components as they are in the file
/// @param scale   Measured::scale of the LUT
/// @param bound   the CIEDE2000 that the LUT may err by
/// @pre the encoding has a way back to XYZ
ClippingLoss clipping_loss(const Image<Rgb>& stored, const Encoding& encoding, double scale, double bound);

/// The share of the points at which measure() looks, in (0, 1].
double measured_share(const Job& job);

/// What baking and measuring a chosen LUT will take: bake() and measure() count the same.
Work bake_work(const Job& job, std::size_t suspects);

}  // namespace nacre
