#include "reference/colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/matrix.h"

namespace nacre::reference {
namespace {

struct Primary {
    double x, y;
};

// Columns are the primaries, scaled so that (1, 1, 1) is the white.
Matrix<double> to_xyz(const Primary& red, const Primary& green, const Primary& blue, const Vector<double>& white) {
    const Vector<double> primaries[3] = {from_chromaticity(red.x, red.y), from_chromaticity(green.x, green.y),
                                         from_chromaticity(blue.x, blue.y)};
    Matrix<double> columns{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) columns[i][j] = primaries[j][i];
    const Vector<double> scale = inverse(columns) * white;
    for (auto& row : columns)
        for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
    return columns;
}

// ITU-R BT.709.
const Matrix<double>& rec709_to_xyz() {
    static const Matrix<double> matrix = to_xyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65_white<double>());
    return matrix;
}

ModelXyz as_xyz(const Vector<double>& xyz) {
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

ModelXyz from_rec709(const ModelRgb& rgb) {
    return as_xyz(rec709_to_xyz() * rgb);
}

ModelXyz from_srgb(const ModelRgb& encoded) {
    ModelRgb rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = encoded[c] <= 0.04045 ? encoded[c] / 12.92 : std::pow((encoded[c] + 0.055) / 1.055, 2.4);
    return from_rec709(rgb);
}

ModelXyz from_p3d65(const ModelRgb& rgb) {
    static const Matrix<double> matrix = to_xyz({0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65_white<double>());
    return as_xyz(matrix * rgb);
}

ModelXyz from_acescg(const ModelRgb& rgb) {
    static const Vector<double> white = from_chromaticity(0.32168, 0.33767);
    static const Matrix<double> matrix = to_xyz({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, white);
    static const Matrix<double> to_d65 = bradford_to_d65<double>(white);
    return as_xyz(to_d65 * (matrix * rgb));
}

std::array<double, 3> oklab_of(const ModelXyz& colour) {
    constexpr Matrix<double> cones{{{0.8189330101, 0.3618667424, -0.1288597137},
                                    {0.0329845436, 0.9293118715, 0.0361456387},
                                    {0.0482003018, 0.2643662691, 0.6338517070}}};
    constexpr Matrix<double> lab{{{0.2104542553, 0.7936177850, -0.0040720468},
                                  {1.9779984951, -2.4285922050, 0.4505937099},
                                  {0.0259040371, 0.7827717662, -0.8086757660}}};
    Vector<double> roots = cones * Vector<double>{colour.x, colour.y, colour.z};
    for (double& root : roots) root = std::cbrt(root);
    return lab * roots;
}

ModelRgb to_rec709(const ModelXyz& colour) {
    static const Matrix<double> matrix = inverse(rec709_to_xyz());
    return matrix * Vector<double>{colour.x, colour.y, colour.z};
}

ModelLab lab_of(const ModelXyz& colour) {
    static const Vector<double> white = d65_white<double>();
    const auto f = [](double ratio) {
        return ratio > 216.0 / 24389.0 ? std::cbrt(ratio) : (24389.0 / 27.0 * ratio + 16.0) / 116.0;
    };
    const double fx = f(colour.x / white[0]), fy = f(colour.y / white[1]), fz = f(colour.z / white[2]);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

double ciede2000(const ModelLab& one, const ModelLab& two) {
    constexpr double pi_number = std::numbers::pi, degree = pi_number / 180.0, full = 2.0 * pi_number;
    const auto seventh = [](double chroma) {
        const double c7 = std::pow(chroma, 7.0);
        return std::sqrt(c7 / (c7 + 6103515625.0));  // 25^7
    };
    const double mean_chroma = (std::hypot(one.a, one.b) + std::hypot(two.a, two.b)) / 2.0;
    const double g = 0.5 * (1.0 - seventh(mean_chroma));
    const double a1 = (1.0 + g) * one.a, a2 = (1.0 + g) * two.a;
    const double c1 = std::hypot(a1, one.b), c2 = std::hypot(a2, two.b);
    const auto hue = [&](double a, double b) {
        if (a == 0.0 && b == 0.0) return 0.0;
        const double angle = std::atan2(b, a);
        return angle < 0.0 ? angle + full : angle;
    };
    const double h1 = hue(a1, one.b), h2 = hue(a2, two.b);
    const bool grey = c1 * c2 == 0.0;

    double dh = grey ? 0.0 : h2 - h1;
    if (dh > pi_number) dh -= full;
    if (dh < -pi_number) dh += full;
    const double d_l = two.l - one.l, d_c = c2 - c1, d_h = 2.0 * std::sqrt(c1 * c2) * std::sin(dh / 2.0);

    double mean_h = h1 + h2;
    if (!grey) {
        if (std::abs(h1 - h2) > pi_number) mean_h += mean_h < full ? full : -full;
        mean_h /= 2.0;
    }
    const double mean_l = (one.l + two.l) / 2.0, mean_c = (c1 + c2) / 2.0;
    const double t = 1.0 - 0.17 * std::cos(mean_h - 30.0 * degree) + 0.24 * std::cos(2.0 * mean_h) +
                     0.32 * std::cos(3.0 * mean_h + 6.0 * degree) - 0.20 * std::cos(4.0 * mean_h - 63.0 * degree);
    const double bell = (mean_h / degree - 275.0) / 25.0;
    const double rotation = -2.0 * seventh(mean_c) * std::sin(60.0 * degree * std::exp(-bell * bell));
    const double square = (mean_l - 50.0) * (mean_l - 50.0);
    const double l_term = d_l / (1.0 + 0.015 * square / std::sqrt(20.0 + square));
    const double c_term = d_c / (1.0 + 0.045 * mean_c);
    const double h_term = d_h / (1.0 + 0.015 * mean_c * t);
    return std::sqrt(std::max(0.0, l_term * l_term + c_term * c_term + h_term * h_term + rotation * c_term * h_term));
}

double difference(const ModelXyz& one, const ModelXyz& two, double scale) {
    const auto lab = [&](const ModelXyz& c) { return lab_of({scale * c.x, scale * c.y, scale * c.z}); };
    return ciede2000(lab(one), lab(two));
}

}  // namespace nacre::reference
