#include "nacre/optics/incidence.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

// theta = 2 asin(sqrt((1 - cos theta) / 2)) is exact near the normal, 90 - asin(cos theta) near grazing.
double theta_deg_of(double cos_theta, double one_minus_cos) {
    if (one_minus_cos < 0.5) return 2.0 * degrees_per_radian * std::asin(std::sqrt(0.5 * one_minus_cos));
    return 90.0 - degrees_per_radian * std::asin(cos_theta);
}

}  // namespace

Incidence Incidence::from_degrees(double theta_deg) {
    return {theta_deg, std::sin((90.0 - theta_deg) / degrees_per_radian)};
}

Incidence Incidence::from_cos(double cos_theta) {
    return {theta_deg_of(cos_theta, 1.0 - cos_theta), cos_theta};
}

Incidence Incidence::from_sqrt_cos(double sqrt_cos_theta) {
    const double cos_theta = sqrt_cos_theta * sqrt_cos_theta;
    return {theta_deg_of(cos_theta, (1.0 - sqrt_cos_theta) * (1.0 + sqrt_cos_theta)), cos_theta};
}

}  // namespace nacre
