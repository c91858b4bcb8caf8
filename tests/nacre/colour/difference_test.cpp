#include "nacre/colour/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/csv.h"

namespace nacre {
namespace {

constexpr Xyz d65 = xyz_from_chromaticity(d65_chromaticity);

TEST(Ciede2000, ThePublishedPairsHaveThePublishedDistancesInBothOrders) {
    const auto rows = test::read_csv(std::string(NACRE_REFERENCE_DATA_DIR) + "/ciede2000_sharma34.csv");
    ASSERT_EQ(rows.size(), 34u);
    for (const auto& row : rows) {
        const Lab one{row[1], row[2], row[3]};
        const Lab other{row[4], row[5], row[6]};
        EXPECT_NEAR(ciede2000(one, other), row[7], 1e-4) << "pair " << row[0];
        EXPECT_NEAR(ciede2000(other, one), row[7], 1e-4) << "pair " << row[0];
        EXPECT_EQ(ciede2000(one, one), 0.0);
    }
}
}  // namespace
}  // namespace nacre
