#include "nacre/pick/lobe/quadratic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace nacre {
namespace {

using Vector = Quadratic::Vector;

// (v - at) . curvature (v - at) / 2
Quadratic bowl(const Vector& at, const std::array<Vector, 3>& curvature) {
    Quadratic result;
    result.curvature = curvature;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.gradient[i] -= curvature[i][j] * at[j];
    for (std::size_t i = 0; i < 3; ++i) result.constant -= 0.5 * result.gradient[i] * at[i];
    return result;
}

TEST(LeastInBox, IsTheBowlsMiddleWhereThatIsInside) {
    const Vector at{0.3, -0.2, 0.7};
    const Quadratic quadratic = bowl(at, {{{4.0, 1.0, 0.5}, {1.0, 3.0, -1.0}, {0.5, -1.0, 2.0}}});
    const Vector found = least_in_box(quadratic, {0.0, 0.0, 0.0}, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], at[i], 1e-12);
    EXPECT_NEAR(quadratic.at(found), 0.0, 1e-12);
}

TEST(LeastInBox, StopsAtItsSides) {
    const Quadratic quadratic = bowl({3.0, 0.5, -3.0}, {{{2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}}});
    const Vector found = least_in_box(quadratic, {0.0, 0.0, 0.0}, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
    EXPECT_NEAR(found[0], 1.0, 1e-12);
    EXPECT_NEAR(found[1], 0.5, 1e-12);
    EXPECT_NEAR(found[2], -1.0, 1e-12);
}

TEST(LeastInBox, NeverGoesUpNorOut) {
    std::mt19937 generator(5);
    const auto random = [&] { return static_cast<double>(generator()) / 2147483648.0 - 1.0; };
    for (int round = 0; round < 2000; ++round) {
        Quadratic quadratic;  // bowls, saddles and hills
        for (std::size_t i = 0; i < 3; ++i) {
            quadratic.gradient[i] = random();
            for (std::size_t j = 0; j <= i; ++j) quadratic.curvature[i][j] = quadratic.curvature[j][i] = random();
        }
        const Vector start{random(), random(), random()};
        const Vector found = least_in_box(quadratic, start, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
        EXPECT_LE(quadratic.at(found), quadratic.at(start) + 1e-12);
        for (const double value : found) EXPECT_LE(std::abs(value), 1.0);
    }
}

}  // namespace
}  // namespace nacre
