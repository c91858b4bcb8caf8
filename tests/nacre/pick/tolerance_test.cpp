#include "nacre/pick/tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace nacre {
namespace {

constexpr int count = 2048;

// A sum of normal variables is one, in every direction: its size has the mean sqrt(2 / pi), and 95 % lie below 1.95996.
TEST(EvenNormalPoints, AreNormalInEveryDirection) {
    for (std::size_t dimensions = 1; dimensions <= 6; ++dimensions) {
        const auto points = even_normal_points(count, dimensions);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
        for (int direction = 1; direction <= 20; ++direction) {
            std::vector<double> sizes;
            double square = 0.0;
            for (std::size_t i = 0; i < dimensions; ++i)
                square += std::pow(std::cos(direction * (static_cast<double>(i) + 1.0)), 2.0);
            for (const std::vector<double>& point : points) {
                double sum = 0.0;
                for (std::size_t i = 0; i < dimensions; ++i)
                    sum += std::cos(direction * (static_cast<double>(i) + 1.0)) * point[i];
                sizes.push_back(std::abs(sum) / std::sqrt(square));
            }
            const ColourShift shift = shift_of(sizes);
            const double mean = std::sqrt(2.0 / std::numbers::pi), percentile_95 = 1.95996;
            EXPECT_NEAR(shift.mean, mean, (dimensions > 2 ? 0.02 : 0.002) * mean) << dimensions << " " << direction;
            EXPECT_NEAR(shift.percentile_95, percentile_95, (dimensions > 2 ? 0.04 : 0.01) * percentile_95)
                << dimensions << " " << direction;
        }
    }
}

TEST(ShiftOf, IsTheMeanAndWhatNineteenOfTwentyDoNotExceed) {
    std::vector<double> de00;
    for (int i = 20; i >= 1; --i) de00.push_back(i);
    EXPECT_EQ(shift_of(de00), (ColourShift{10.5, 19.0}));
    EXPECT_EQ(shift_of({3.0}), (ColourShift{3.0, 3.0}));
}

}  // namespace
}  // namespace nacre
