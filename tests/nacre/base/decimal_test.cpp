// Decimal text of doubles: the C library's way, which WebAssembly takes, against <charconv>.
#include "nacre/base/decimal.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace nacre {
namespace {

std::string by_charconv(double value) {
    std::array<char, 64> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

TEST(Decimal, ShortestIsThatOfCharconv) {
    std::mt19937_64 random(21);
    std::uniform_int_distribution<int> digits(0, 9);
    for (int i = 0; i < 200000; ++i) {
        const auto bits = std::bit_cast<double>(random());
        const double plain = static_cast<double>(static_cast<std::int64_t>(random() % 2000000) - 1000000) /
                             std::pow(10.0, digits(random));
        for (const double value : {bits, plain}) {
            if (std::isnan(value)) continue;
            EXPECT_EQ(by_c_library::shortest_decimal(value), by_charconv(value));
        }
    }
}

TEST(Decimal, ShortestOfNumbersAtTheEdges) {
    for (const double value : {0.0,
                               -0.0,
                               1.0,
                               100.0,
                               1000.0,
                               100000.0,
                               123456.0,
                               1e15,
                               1e16,
                               1e17,
                               1e22,
                               1e23,
                               0.001,
                               0.0001,
                               0.00001,
                               1e-5,
                               1.5e-5,
                               5e-324,
                               1.7976931348623157e308,
                               123456789012345680.0,
                               9007199254740993.0,
                               1.0 / 3.0,
                               HUGE_VAL,
                               -HUGE_VAL})
        EXPECT_EQ(by_c_library::shortest_decimal(value), by_charconv(value));
}

TEST(Decimal, RoundedIsThatOfCharconv) {
    std::mt19937_64 random(22);
    std::uniform_real_distribution<double> numbers(-1000.0, 1000.0);
    for (int i = 0; i < 20000; ++i) {
        const double value = numbers(random);
        EXPECT_EQ(by_c_library::fixed_decimal(value, i % 12), fixed_decimal(value, i % 12));
        EXPECT_EQ(by_c_library::rounded_to_digits(value, 1 + i % 15), rounded_to_digits(value, 1 + i % 15));
    }
    EXPECT_EQ(fixed_decimal(0.125, 2), "0.12");
    EXPECT_EQ(rounded_to_digits(0.0213, 2), 0.021);
}

TEST(Decimal, ReadsWhatCharconvReads) {
    for (const char* const text :
         {"1",      "-1",  "1.5",      ".5",    "5.",     "1e3",  "1E+3",     "-0",    "inf", "-inf",
          "1e-400", "0e5", "0.0e-999", "1e999", "-1e999", "",     " 1",       "1 ",    "+1",  "0x10",
          "1,5",    "e5",  "-",        "1e",    "--1",    "1e5x", "4.9e-324", "1e-320"}) {
        const auto mine = by_c_library::read_decimal(text);
        const auto standard = read_decimal(text);
        EXPECT_EQ(mine.has_value(), standard.has_value()) << text;
        if (mine && standard) {
            EXPECT_EQ(*mine, *standard) << text;
        }
    }
}

}  // namespace
}  // namespace nacre
