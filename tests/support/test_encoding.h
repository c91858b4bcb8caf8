#pragma once

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/formats.h"

namespace nacre::test {

/// The nearest half, ties to even (IEEE 754-2008, binary16); infinite from 65520 on.
inline double nearest_half(double value) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    // 11 significant bits; below 2^-14 steps of 2^-24. nearbyint rounds ties to even.
    const int exponent = std::max(std::ilogb(value) - 10, -24);
    const double rounded = std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
    return std::abs(rounded) > 65504.0 ? std::copysign(std::numeric_limits<double>::infinity(), value) : rounded;
}

inline double nearest_float(double value) {
    // Through memory, because GCC 12 drops the rounding where it vectorizes two of them (seen at -O2, not at -O1).
    const volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

inline double stored_as(double value, PixelFormat format) {
    return format == PixelFormat::half_float ? nearest_half(value) : nearest_float(value);
}

template <typename To, typename From, typename Convert>
Image<To> converted(const Image<From>& image, Convert convert) {
    Image<To> result(image.width(), image.height());
    std::transform(image.begin(), image.end(), result.begin(), convert);
    return result;
}

/// Linear Rec.709 by its primaries and nothing else: what the program's encoding is without OpenColorIO.
inline Encoding rec709_encoding() {
    const glm::dmat3 to_rgb = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
    const glm::dmat3 to_xyz = glm::inverse(to_rgb);
    Encoding encoding;
    encoding.to_rgb = [to_rgb](const Image<Xyz>& image) {
        return converted<Rgb>(image, [&](const Xyz& colour) {
            const Xyz rgb = adapt(to_rgb, colour);
            return Rgb{rgb.x, rgb.y, rgb.z};
        });
    };
    encoding.to_xyz = [to_xyz](const Image<Rgb>& image) {
        return converted<Xyz>(image, [&](const Rgb& colour) { return adapt(to_xyz, {colour.r, colour.g, colour.b}); });
    };
    encoding.stored = stored_as;
    return encoding;
}

/// Components as they are in a file of that format.
inline Image<Rgb> stored_as(const Image<Rgb>& image, PixelFormat format) {
    return converted<Rgb>(image, [&](const Rgb& texel) {
        return Rgb{stored_as(texel.r, format), stored_as(texel.g, format), stored_as(texel.b, format)};
    });
}

}  // namespace nacre::test
