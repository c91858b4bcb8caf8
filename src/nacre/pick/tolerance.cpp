#include "nacre/pick/tolerance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/base/even_points.h"
#include "nacre/base/gauss_points.h"

namespace nacre {

ColourShift shift_of(std::vector<double> de00) {
    constexpr double share = 0.95;
    const auto count = static_cast<double>(de00.size());
    const auto at = de00.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * count) - 1.0);
    const double mean = std::accumulate(de00.begin(), de00.end(), 0.0) / count;
    std::nth_element(de00.begin(), at, de00.end());
    return {mean, *at};
}

namespace {

// Gives every variable the mean 0 and the variance 1, and makes them uncorrelated, one after the other (Gram and
// Schmidt): then the second moments of every direction are exact.
void make_uncorrelated(std::vector<std::vector<double>>& points) {
    const auto mean_product = [&](std::size_t i, std::size_t j) {
        double sum = 0.0;
        for (const std::vector<double>& point : points) sum += point[i] * point[j];
        return sum / static_cast<double>(points.size());
    };
    for (std::size_t i = 0; i < points.front().size(); ++i) {
        double mean = 0.0;
        for (const std::vector<double>& point : points) mean += point[i] / static_cast<double>(points.size());
        for (std::vector<double>& point : points) point[i] -= mean;
        for (std::size_t j = 0; j < i; ++j) {
            const double shared = mean_product(i, j);
            for (std::vector<double>& point : points) point[i] -= shared * point[j];
        }
        const double deviation = std::sqrt(mean_product(i, i));
        for (std::vector<double>& point : points) point[i] /= deviation;
    }
}

}  // namespace

std::vector<std::vector<double>> even_normal_points(int count, std::size_t dimensions) {
    constexpr double least_share = 1e-9;  // six standard deviations; no sequence of some thousand points gets as far
    const EvenPoints even(dimensions);
    std::vector<std::vector<double>> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(even.at(i));
        for (double& at : points.back()) {
            const double beyond = std::max(std::min(at, 1.0 - at), least_share);
            at = std::copysign(normal_above(beyond), at - 0.5);
        }
    }
    make_uncorrelated(points);
    return points;
}

}  // namespace nacre
