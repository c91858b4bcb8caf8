#pragma once

#include <array>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>

#include "nacre/base/image.h"
#include "nacre/base/words.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/gamut_compression.h"

namespace nacre {

/// What happens to colours that the target's primaries cannot make, i.e. to negative components.
///
/// `keep` writes them as they are: right in colour, and what a shader that renders in a wider space wants.
/// `clip` cuts at zero: shifts hue and raises luminance, and what differs by its negative components becomes one
/// colour. `compress` lowers chroma and keeps hue and lightness as they are seen, see GamutCompression.
enum class Gamut { keep, clip, compress };

inline constexpr std::array gamut_words{
    Word<Gamut>{"keep", Gamut::keep, "negative components stay, and are counted"},
    Word<Gamut>{"clip", Gamut::clip, "negative components become 0"},
    Word<Gamut>{"compress", Gamut::compress,
                "less chroma at the same hue and lightness (Oklab), until nothing is negative"},
};

/// A component below this is outside the gamut, not rounding.
///
/// OpenColorIO computes in float: components of order 1 carry some 1e-7, and a colour on the hull of the gamut (black,
/// a pure primary) lands on either side of zero by that much. Half, the file's type, resolves 1e-6 only below 0.002.
inline constexpr double gamut_tolerance = -1e-6;

struct GamutReport {
    std::size_t outside = 0;     ///< texels with a component below gamut_tolerance
    double most_negative = 0.0;  ///< the smallest component of all, 0 when none is negative
    friend bool operator==(const GamutReport&, const GamutReport&) = default;
};

/// Negative components become 0 (and -0 becomes 0).
Rgb clip_to_gamut(Rgb colour);

/// How much of the image is outside.
GamutReport gamut_report(const Image<Rgb>& image);

/// A rule, made ready for one space. May be used from many threads.
class GamutRule {
public:
    /// @param rgb_of_xyz  XYZ (D65) to the target, if that is all there is between them; read by `compress` only
    /// @pre for `compress` there is one, and grey has components > 0
    GamutRule(Gamut gamut, const std::optional<glm::dmat3>& rgb_of_xyz);

    /// Treats every pixel of the image.
    ///
    /// @param image  RGB of the target
    /// @param xyz    the same pixels before the conversion, Y = 1 for the perfect reflector; read by `compress` only
    /// @pre for `compress`, both have the same size
    void apply(Image<Rgb>& image, const Image<Xyz>& xyz) const;

private:
    Gamut gamut_;
    std::optional<GamutCompression> compression_;
};

}  // namespace nacre
