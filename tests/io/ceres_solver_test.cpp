#include "io/ceres_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>

namespace nacre {
namespace {

TEST(LeastSquares, FindTheRootOfABentSystem) {
    LeastSquares problem;
    problem.parameters = 3;
    problem.residuals = 3;
    problem.evaluate = [](std::span<const double> v, std::span<double> residuals) {
        residuals[0] = v[0] * v[0] + v[1] - 3.0;
        residuals[1] = v[1] * v[2] - 2.0;
        residuals[2] = v[0] + v[1] + v[2] - 4.0;
    };
    std::array v{0.5, 0.5, 0.5};
    least_squares_solver()(problem, v, 60);
    std::array<double, 3> left{};
    problem.evaluate(v, left);
    for (const double residual : left) EXPECT_NEAR(residual, 0.0, 1e-4);
}

TEST(LeastSquares, AreRosenbrocksWhereHeSaid) {
    LeastSquares problem;
    problem.parameters = 2;
    problem.residuals = 2;
    problem.evaluate = [](std::span<const double> v, std::span<double> residuals) {
        residuals[0] = 10.0 * (v[1] - v[0] * v[0]);
        residuals[1] = 1.0 - v[0];
    };
    std::array v{-1.2, 1.0};
    least_squares_solver()(problem, v, 100);
    EXPECT_NEAR(v[0], 1.0, 1e-4);
    EXPECT_NEAR(v[1], 1.0, 1e-4);
}

TEST(LeastSquares, TakeNoMoreStepsThanTheyMay) {
    LeastSquares problem;
    problem.parameters = 1;
    problem.residuals = 1;
    int calls = 0;
    problem.evaluate = [&](std::span<const double> v, std::span<double> residuals) {
        ++calls;
        residuals[0] = std::exp(v[0]) + 1.0;
    };
    std::array v{0.0};
    least_squares_solver()(problem, v, 3);
    EXPECT_LE(calls, 20);
    EXPECT_LT(v[0], 0.0);
}

}  // namespace
}  // namespace nacre
