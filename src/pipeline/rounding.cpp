#include "pipeline/rounding.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace nacre {

double rounded_up(double error) {
    if (!(error > 0.0) || !std::isfinite(error)) return error;
    const double unit = std::pow(10.0, std::floor(std::log10(error)) - 2.0);
    // By way of text, so that 0.0213 is the number that is written 0.0213.
    char text[32];
    std::snprintf(text, sizeof text, "%.2e", std::ceil(error / unit * (1.0 - 1e-9)) * unit);
    return std::strtod(text, nullptr);
}

double rounded_angle(double angle_deg) {
    return std::round(angle_deg * 1e6) / 1e6;
}

}  // namespace nacre
