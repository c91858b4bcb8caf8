#pragma once

#include <cstddef>
#include <span>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// How far a finished LUT is from the truth.
struct Measured {
    double reached = 0.0;              ///< CIEDE2000 that it errs by at most, at any coordinate
    LutPoint at;                       ///< where the reference found the largest error
    double of_texels = 0.0;            ///< CIEDE2000 from the bake's own model at most, at all coordinates
    double of_model = 0.0;             ///< and of that model from the reference, or from twice as many nodes
    double scale = 1.0;                ///< how many times brighter colours were shown, see display_scale()
    std::size_t model_points = 0;      ///< at which the LUT was compared with the bake's own model
    std::size_t reference_points = 0;  ///< at which both were compared with the independent reference
    Work work;
};

/// An upper estimate of a chosen LUT's error: what it is from the bake's own model at most, at all coordinates, and
/// what that model is from Reference, at the points where the LUT errs most and at others spread evenly; or what the
/// LUT itself is from Reference, where that is more.
/// @param texels  what was baked
/// @param stored  the components as they are in the file
/// @pre the encoding has a way back to XYZ
Measured measure(const ChosenLut& chosen, const Image<Xyz>& texels, const Image<Rgb>& stored, const Encoding& encoding);

/// The largest error found at a few points alone: fetches from the stored numbers as a shader does, and compares with
/// Reference, at the points given, at `spread_points` more that lie between the texels all over the LUT, and at its
/// corners. Where a colour takes the reference long beside the texels of the LUT, there are fewer of both.
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

/// What measure() lets the reference err by, CIEDE2000.
double tolerance_of_reference(double max_de00);

/// The share of the points at which measure() looks, in (0, 1].
double measured_share(const Job& job);

/// What baking and measuring a chosen LUT will take: bake() and measure() count the same.
Work bake_work(const Job& job, std::size_t suspects);

}  // namespace nacre
