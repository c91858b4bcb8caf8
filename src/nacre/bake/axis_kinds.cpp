#include "nacre/bake/axis_kinds.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

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

Incidence incidence_of_quarter_turns(double quarter_turns) {
    return Incidence::from_degrees(90.0 * quarter_turns);
}

constexpr std::array<AxisKind, 3> kinds{{
    {"sqrt_cos_theta", "square root of the cosine: most texels where iridescent colour changes fastest", square_root,
     square, Incidence::from_sqrt_cos, "sqrt(c)"},
    {"cos_theta", "the cosine itself: for engines that fix this axis", identity, identity, Incidence::from_cos, "c"},
    {"theta_deg", "the angle, 0 to 90 degrees: even steps of angle", quarter_turns_of_cos, cos_of_quarter_turns,
     incidence_of_quarter_turns, "1.2732395447 * atan(sqrt((1.0 - c) / (1.0 + c)))"},
}};

}  // namespace

std::span<const AxisKind> axis_kinds() {
    return kinds;
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
