#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// `[colour] gamut = "compress"`: colours that a linear space lacks become the less saturated ones that it has.
///
/// Works in Oklab (see colour/oklab.h) and changes nothing but chroma: hue and lightness of the result are those of the
/// colour. It commutes with exposure, because components above 1 are light like any other: the gamut is a cone, and
/// whether Oklab's (L, a, b) lies in it depends on hue and on saturation, C / L, alone. So one curve over hue, the
/// edge, is the whole gamut, and no colour has to become lighter or darker to fit.
///
/// Up to `1 - room` of the edge a colour stays as it is, bit for bit. Beyond, saturation d (in edges) becomes
///   1 - room + room x / sqrt(1 + x²),   x = (d - 1 + room) / room,
/// the curve of the ACES Reference Gamut Compression (Academy TB-2021-001) without a limit and with its power set to 2,
/// at which it has two continuous derivatives and needs a square root only. It grows with d and never arrives at 1.
/// The room is what has to be fit in: the farthest real colour of that hue (spectral colours of the CIE 1931 observer
/// and the purples between their ends) is reach edges away, and room = reach - 1 within [0, 0.2]. Where the space holds
/// every real colour, as ACES2065-1 nearly does, next to nothing is bent.
///
/// The edge that is used lies inside the gamut's own, with the corners at the primaries made round: 2 % of its chroma
/// at Rec.709's green, more at its blue. There the hull hangs over by up to a degree of hue (beside the blues of
/// Rec.709, Rec.2020 and AP1), and a hue that turns a little would lose a tenth of its chroma at once: Rec.709's own
/// (0, 0, 1) becomes (0.00, 0.04, 0.71). With corners a rainbow has bright lines, and the LUT of a Morpho errs by 0.17
/// with 4096 texels, where it errs by 0.035 with 2048 without.
///
/// Lobes 50 nm wide, 400 to 680 nm, in Rec.709: CIEDE2000 from what was meant is 12.1 in the mean, where clipping has
/// 11.0 but turns hue by up to 40°, and mixing with grey of the same luminance, which makes violets black, has 13.2 and
/// 26°. Luminance is not kept: Oklab takes a spectral violet for lighter than its luminance says, as eyes do, so its
/// Rec.709 form has up to 6 times as much; clipping gives it 19 times.
///
/// Why not OpenColorIO: 2.1 has ACES_GAMUT_COMP_13, made for AP1, which keeps neither hue nor lightness; 2.4 adds
/// ACES_GAMUT_COMPRESS_20, which keeps hue and takes any primaries, but is a step of a display rendering: light ends at
/// a peak luminance, and is expected to have been tone mapped. And a LUT has to verify with any version.
class GamutCompression {
public:
    /// @param rgb_of_xyz  to the target's linear RGB from XYZ (D65); grey has components > 0
    explicit GamutCompression(const glm::dmat3& rgb_of_xyz);

    /// @param rgb     the colour in the target; returned as it is, bit for bit, where nothing has to be done
    /// @param colour  the same as XYZ; a colour with no lightness becomes black
    /// @return no component is negative. Lightness is the colour's within 1e-12, hue within 1e-10 radians
    ///         divided by chroma; an imaginary colour may miss hue by more
    Rgb operator()(Rgb rgb, Xyz colour) const;

    /// Saturation, as fraction of the edge's, to that of the result. Ascending, at most `distance`, at most 1.
    /// @param distance  >= 0
    /// @param room      in [0, 0.2]
    static double nearer(double distance, double room);

    struct Bound {
        double edge = 0.0;  ///< saturation, C / L in Oklab, at which the gamut ends
        double room = 0.0;  ///< the last part of it, into which what lies outside is bent
    };
    /// @param a,b  of Oklab: only their ratio counts
    Bound bound(double a, double b) const;

private:
    glm::dmat3 rgb_of_xyz_;
    std::vector<Bound> bounds_;  // over hue, evenly; the last is the first again
};

}  // namespace nacre
