#include "nacre/base/even_points.h"

#include <cmath>

namespace nacre {
namespace {

// The root of x^(dimensions + 1) = x + 1 above 1: the golden ratio and its generalisation to more dimensions.
double generalised_golden_ratio(std::size_t dimensions) {
    constexpr int steps = 64;  // each gains about a digit
    double x = 2.0;
    for (int step = 0; step < steps; ++step) x = std::pow(1.0 + x, 1.0 / (static_cast<double>(dimensions) + 1.0));
    return x;
}

}  // namespace

EvenPoints::EvenPoints(std::size_t dimensions) {
    const double ratio = generalised_golden_ratio(dimensions);
    for (std::size_t i = 0; i < dimensions; ++i) steps_.push_back(std::pow(1.0 / ratio, static_cast<double>(i + 1)));
}

std::vector<double> EvenPoints::at(int index) const {
    std::vector<double> point;
    for (const double step : steps_) point.push_back(std::fmod(0.5 + step * (index + 1), 1.0));
    return point;
}

}  // namespace nacre
