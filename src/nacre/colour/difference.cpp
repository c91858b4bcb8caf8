#include "nacre/colour/difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

// Cube root, and its tangent at (6/29)^3 below that.
double lab_function(double t) {
    constexpr double bend = (6.0 / 29.0) * (6.0 / 29.0) * (6.0 / 29.0);
    return t > bend ? std::cbrt(t) : (841.0 / 108.0) * t + 4.0 / 29.0;
}

double from_lab_function(double f) {
    return f > 6.0 / 29.0 ? f * f * f : (108.0 / 841.0) * (f - 4.0 / 29.0);
}

// In [0, 360); 0 for grey.
double hue_deg(double a, double b) {
    if (a == 0.0 && b == 0.0) return 0.0;
    const double hue = std::atan2(b, a) * degrees_per_radian;
    return hue < 0.0 ? hue + 360.0 : hue;
}

// c^7 / (c^7 + 25^7), the square root of which bends greys and blues.
double seventh_power_share(double chroma) {
    const double c2 = chroma * chroma;
    const double c7 = c2 * c2 * c2 * chroma;
    return std::sqrt(c7 / (c7 + 6103515625.0));
}

}  // namespace

Lab to_lab(Xyz colour, Xyz white) {
    const double fx = lab_function(colour.x / white.x);
    const double fy = lab_function(colour.y / white.y);
    const double fz = lab_function(colour.z / white.z);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Xyz from_lab(const Lab& lab, Xyz white) {
    const double fy = (lab.l + 16.0) / 116.0;
    return {white.x * from_lab_function(fy + lab.a / 500.0), white.y * from_lab_function(fy),
            white.z * from_lab_function(fy - lab.b / 200.0)};
}

namespace {

struct Steps {
    double lightness;
    double chroma;
    double hue;
    double rotation;
};

// @param side  0, or the way round that is counted where hues are nearly opposite: 1 upwards from one's, -1 downwards
// 1 - 0.17 cos(h - 30) + 0.24 cos 2h + 0.32 cos(3h + 6) - 0.20 cos(4h - 63), by the addition theorems: this function is
// called for every point of every LUT that is tried, and cosines took a fifth of its time.
double hue_weight(double hue_deg) {
    const double radians = hue_deg / degrees_per_radian;
    const double c1 = std::cos(radians), s1 = std::sin(radians);
    const double c2 = c1 * c1 - s1 * s1, s2 = 2.0 * s1 * c1;
    const double c3 = c2 * c1 - s2 * s1, s3 = s2 * c1 + c2 * s1;
    const double c4 = c2 * c2 - s2 * s2, s4 = 2.0 * s2 * c2;
    constexpr double cos_30 = 0.86602540378443865, sin_30 = 0.5;
    constexpr double cos_6 = 0.99452189536827333, sin_6 = 0.10452846326765347;
    constexpr double cos_63 = 0.45399049973954675, sin_63 = 0.89100652418836787;
    return 1.0 - 0.17 * (c1 * cos_30 + s1 * sin_30) + 0.24 * c2 + 0.32 * (c3 * cos_6 - s3 * sin_6) -
           0.20 * (c4 * cos_63 + s4 * sin_63);
}

double length(double a, double b) {
    return std::sqrt(a * a + b * b);
}

Steps steps_between(const Lab& one, const Lab& other, double side) {
    const double mean_plain_chroma = 0.5 * (length(one.a, one.b) + length(other.a, other.b));
    const double stretch = 1.0 + 0.5 * (1.0 - seventh_power_share(mean_plain_chroma));
    const double a1 = stretch * one.a;
    const double a2 = stretch * other.a;
    const double chroma1 = length(a1, one.b);
    const double chroma2 = length(a2, other.b);
    const double hue1 = hue_deg(a1, one.b);
    const double hue2 = hue_deg(a2, other.b);

    const double lightness_step = other.l - one.l;
    const double chroma_step = chroma2 - chroma1;
    const bool is_grey = chroma1 * chroma2 == 0.0;
    double hue_step_deg = is_grey ? 0.0 : hue2 - hue1;
    if (hue_step_deg > 180.0) hue_step_deg -= 360.0;
    if (hue_step_deg < -180.0) hue_step_deg += 360.0;
    const bool goes_other_way = side * hue_step_deg < -90.0;
    if (goes_other_way) hue_step_deg += 360.0 * side;
    const double hue_step = 2.0 * std::sqrt(chroma1 * chroma2) * std::sin(0.5 * hue_step_deg / degrees_per_radian);

    const double lightness = 0.5 * (one.l + other.l);
    const double chroma = 0.5 * (chroma1 + chroma2);
    double hue = hue1 + hue2;  // grey has no hue: the other's counts
    if (!is_grey) {
        if (std::abs(hue1 - hue2) > 180.0) hue += hue < 360.0 ? 360.0 : -360.0;
        hue *= 0.5;
        if (goes_other_way) hue += hue < 180.0 ? 180.0 : -180.0;
    }
    const double t = hue_weight(hue);
    const double from_middle = (lightness - 50.0) * (lightness - 50.0);
    const double s_l = 1.0 + 0.015 * from_middle / std::sqrt(20.0 + from_middle);
    const double s_c = 1.0 + 0.045 * chroma;
    const double s_h = 1.0 + 0.015 * chroma * t;
    const double blue = (hue - 275.0) / 25.0;
    const double rotation =
        -2.0 * seventh_power_share(chroma) * std::sin(2.0 * 30.0 * std::exp(-blue * blue) / degrees_per_radian);

    return {lightness_step / s_l, chroma_step / s_c, hue_step / s_h, rotation};
}

}  // namespace

double ciede2000(const Lab& one, const Lab& other) {
    const auto [l, c, h, rotation] = steps_between(one, other, 0.0);
    // The form is positive definite (|rotation| < 2), but rounding may leave a value slightly below 0. NaN stays NaN:
    // fmax() would hide it.
    const double square = l * l + c * c + h * h + rotation * c * h;
    return std::sqrt(square < 0.0 ? 0.0 : square);
}

std::array<double, 3> ciede2000_parts(const Lab& one, const Lab& other, double side) {
    const auto [l, c, h, rotation] = steps_between(one, other, side);
    const double half = 0.5 * rotation;
    return {l, c + half * h, h * std::sqrt(std::max(0.0, (1.0 - half) * (1.0 + half)))};
}

double display_scale(double luminance) {
    return luminance > black_luminance ? 1.0 / luminance : 1.0;
}

double difference_at(const Xyz& one, const Xyz& other, double scale) {
    const auto lab = [scale](const Xyz& colour) {
        return to_lab({scale * colour.x, scale * colour.y, scale * colour.z}, d65_white);
    };
    return ciede2000(lab(one), lab(other));
}

}  // namespace nacre
