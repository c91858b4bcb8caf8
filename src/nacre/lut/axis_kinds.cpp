#include "nacre/lut/axis_kinds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "nacre/optics/incidence.h"

namespace nacre {
namespace {

double identity(double value) {
    return value;
}
double square_root(double value) {
    return std::sqrt(value);
}
double square(double value) {
    return value * value;
}

// theta = 2 atan(tan(theta / 2)) with tan^2(theta / 2) = (1 - c) / (1 + c): no singularity in [0, 1] and full accuracy
// at both ends. The shader writes the same, because the acos of graphics drivers is poor:
// Mesa's errs by 1e-4 of this axis, its atan by 4e-6.
double quarter_turns_of_cos(double cos_theta) {
    return 4.0 * std::numbers::inv_pi * std::atan(std::sqrt((1.0 - cos_theta) / (1.0 + cos_theta)));
}

// cos(x) as sin(pi/2 - x), so that 1 gives exactly 0.
double cos_of_quarter_turns(double quarter_turns) {
    return std::sin((1.0 - quarter_turns) * 0.5 * std::numbers::pi);
}

Geometry from_sqrt_cos(double coordinate) {
    return Incidence::from_sqrt_cos(coordinate);
}
Geometry from_cos(double coordinate) {
    return Incidence::from_cos(coordinate);
}
Geometry from_quarter_turns(double quarter_turns) {
    return Incidence::from_degrees(90.0 * quarter_turns);
}

double half(double u) {
    return 0.5 * std::abs(u);
}
double twice(double coordinate) {
    return 2.0 * coordinate;
}
Geometry from_half_u(double coordinate) {
    return Geometry::from_grating_u(twice(coordinate));
}

double raised(double cos_scatter) {
    return 0.5 + 0.5 * cos_scatter;
}
double lowered(double coordinate) {
    return 2.0 * coordinate - 1.0;
}
Geometry from_raised(double coordinate) {
    return Geometry::from_cos_scatter(lowered(coordinate));
}

constexpr std::array<AxisKind, 5> kinds{{
    {"sqrt_cos_theta", Quantity::incidence,
     "square root of the cosine: most texels where iridescent colour changes fastest", "cos_theta", 0.0, 1.0,
     square_root, square, from_sqrt_cos, "sqrt(c)"},
    {"cos_theta", Quantity::incidence, "the cosine itself: for engines that fix this axis", "cos_theta", 0.0, 1.0,
     identity, identity, from_cos, "c"},
    {"theta_deg", Quantity::incidence, "the angle, 0 to 90 degrees: even steps of angle", "cos_theta", 0.0, 1.0,
     quarter_turns_of_cos, cos_of_quarter_turns, from_quarter_turns,
     "1.2732395447 * atan(sqrt((1.0 - c) / (1.0 + c)))"},
    {"grating_u", Quantity::grating_u, "gratings: dot(L + V, t), t the direction across the grooves; either sign", "u",
     -2.0, 2.0, half, twice, from_half_u, "0.5 * abs(c)"},
    {"cos_scatter", Quantity::cos_scatter, "scattering: the cosine of the angle by which light is turned, dot(-L, V)",
     "cos_scatter", -1.0, 1.0, raised, lowered, from_raised, "0.5 + 0.5 * c"},
}};

}  // namespace

std::span<const AxisKind> axis_kinds() {
    return kinds;
}

const AxisKind& default_axis_kind(Quantity quantity) {
    return *std::find_if(kinds.begin(), kinds.end(), [&](const AxisKind& kind) { return kind.quantity == quantity; });
}

double coordinate_of_texel(int texel, int size) {
    assert(texel >= 0 && texel < size);
    if (size == 1) return 0.0;
    return static_cast<double>(texel) / static_cast<double>(size - 1);
}

double texcoord_of(double coordinate, int size) {
    assert(size >= 1);
    return (coordinate * (size - 1) + 0.5) / size;
}

}  // namespace nacre
