#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "nacre/pick/mechanism_search.h"

namespace nacre {
namespace {

FreeNumber number_of(double low, double high, FreeScale scale) {
    FreeNumber number;
    number.name = "n";
    number.low = low;
    number.high = high;
    number.scale = scale;
    return number;
}

TEST(FreeNumber, HasItsEndsExactly) {
    for (const FreeScale scale : {FreeScale::even, FreeScale::ratio, FreeScale::whole}) {
        for (const auto& [low, high] : {std::pair{1.0, 2.0}, {1.0, 200.0}, {3.0, 7.0}, {400.0, 5000.0}, {10.0, 1e6}}) {
            const FreeNumber number = number_of(low, high, scale);
            EXPECT_EQ(number.at(0.0), low);
            EXPECT_EQ(number.at(1.0), high);
        }
    }
    const FreeNumber thin = number_of(0.1, 0.7, FreeScale::even);
    EXPECT_EQ(thin.at(0.0), 0.1);
    EXPECT_EQ(thin.at(1.0), 0.7);
    EXPECT_EQ(thin.place_of(0.1), 0.0);
    EXPECT_EQ(thin.place_of(0.7), 1.0);
}

TEST(FreeNumber, AtAndPlaceOfAreInverse) {
    for (const FreeScale scale : {FreeScale::even, FreeScale::ratio}) {
        const FreeNumber number = number_of(400.0, 5000.0, scale);
        double before = 0.0;
        for (int i = 0; i <= 1000; ++i) {
            const double u = i / 1000.0;
            const double value = number.at(u);
            EXPECT_GE(value, 400.0);
            EXPECT_LE(value, 5000.0);
            EXPECT_GT(value, before);
            before = value;
            EXPECT_NEAR(number.place_of(value), u, 1e-14);
            EXPECT_NEAR(number.at(number.place_of(value)), value, 1e-10);
        }
    }
    EXPECT_NEAR(number_of(100.0, 400.0, FreeScale::even).at(0.5), 250.0, 1e-12);
    EXPECT_NEAR(number_of(100.0, 400.0, FreeScale::ratio).at(0.5), 200.0, 1e-12);
}

TEST(FreeNumber, ReachesEveryWholeNumberAndStaysThere) {
    for (const auto& [low, high] : {std::pair{1, 40}, {1, 200}, {1, 2}, {7, 7}, {10, 1000}}) {
        const FreeNumber number = number_of(low, high, FreeScale::whole);
        for (int whole = low; whole <= high; ++whole) EXPECT_EQ(number.at(number.place_of(whole)), whole);
        // Evenly spread places reach all of them, too: the narrowest share is that of the last.
        std::set<double> reached;
        for (int i = 0; i <= 10000; ++i) {
            const double value = number.at(i / 10000.0);
            EXPECT_EQ(value, std::round(value));
            EXPECT_GE(value, low);
            EXPECT_LE(value, high);
            reached.insert(value);
        }
        EXPECT_EQ(static_cast<int>(reached.size()), high - low + 1);
    }
}

TEST(FreeNumber, OfNoWidthIsItsValue) {
    for (const FreeScale scale : {FreeScale::even, FreeScale::ratio, FreeScale::whole}) {
        const FreeNumber number = number_of(3.0, 3.0, scale);
        for (const double u : {0.0, 0.3, 1.0}) EXPECT_EQ(number.at(u), 3.0);
        EXPECT_EQ(number.place_of(3.0), 0.0);
    }
    EXPECT_EQ(number_of(0.0, 0.0, FreeScale::even).at(0.7), 0.0);
}

}  // namespace
}  // namespace nacre
