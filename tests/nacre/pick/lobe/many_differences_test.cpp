// Differences side by side against CIEDE2000 one by one.
#include "nacre/pick/lobe/many_differences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace nacre {
namespace {

constexpr std::size_t count = 203;  // no whole number of registers
struct Rows {
    std::vector<float> x, y, z, factor;
    std::vector<Xyz> colours;

    RootColours view() const { return {x.data(), y.data(), z.data(), factor.data(), count}; }
};

// Colours from nearly black to white, dimmed; the first ones next to `near`.
Rows random_rows(std::mt19937& generator, const Xyz& near) {
    const auto random = [&] { return static_cast<double>(generator()) / 4294967296.0; };
    Rows rows;
    for (std::vector<float>* row : {&rows.x, &rows.y, &rows.z, &rows.factor})
        row->assign(count + RootColours::padding, 1.0F);
    for (std::size_t i = 0; i < count; ++i) {
        Xyz colour{random() * random(), random() * random(), random() * random()};
        if (i < 20) colour = {near.x + 1e-4 * random(), near.y + 1e-3 * random(), near.z};
        const double height = i < 20 ? 0.99 : random();
        rows.x[i] = static_cast<float>(colour.x / d65_white.x);
        rows.y[i] = static_cast<float>(colour.y);
        rows.z[i] = static_cast<float>(colour.z / d65_white.z);
        rows.factor[i] = static_cast<float>(std::cbrt(height));
        rows.colours.push_back({height * colour.x, height * colour.y, height * colour.z});
    }
    for (std::vector<float>* row : {&rows.x, &rows.y, &rows.z}) cube_roots(row->data(), count);
    return rows;
}

// Of hues in L*a*b*, in degrees; CIEDE2000, which stretches a*, jumps near 180.
double hue_difference_deg(const Lab& one, const Lab& other) {
    const double sine = one.a * other.b - one.b * other.a, cosine = one.a * other.a + one.b * other.b;
    return std::abs(std::atan2(sine, cosine)) * 57.29577951308232;
}

TEST(ManyDifferences, AreCiede2000) {
    std::mt19937 generator(3);
    std::vector<float> squares(count + RootColours::padding);
    for (int round = 0; round < 300; ++round) {
        const auto random = [&] { return static_cast<double>(generator()) / 4294967296.0; };
        Xyz target{random(), random(), random()};
        if (round % 10 == 0) target = {0.2 * d65_white.x, 0.2, 0.2 * d65_white.z};
        if (round % 10 == 1) target = {0.002 * random(), 0.002 * random(), 0.002 * random()};
        const Lab lab = to_lab(target, d65_white);
        const Rows rows = random_rows(generator, target);
        many_differences(lab, rows.view(), squares.data());
        for (std::size_t i = 0; i < count; ++i) {
            const Lab other = to_lab(rows.colours[i], d65_white);
            constexpr double opposite_deg = 165.0;
            if (hue_difference_deg(lab, other) > opposite_deg) continue;
            const double expected = ciede2000(lab, other);
            ASSERT_NEAR(std::sqrt(squares[i]), expected, 1e-3 * expected + 1e-3) << round << " " << i;
        }
    }
}

// Beyond the opposite hue CIEDE2000 goes on as on the side that is asked for: it does not jump.
TEST(ManyDifferences, GoOnBeyondTheOppositeHue) {
    const Lab target = to_lab({0.30, 0.17, 0.12}, d65_white);
    std::vector<float> rows(4 * (count + RootColours::padding), 1.0F);
    const auto row = [&](std::size_t i) { return rows.data() + i * (count + RootColours::padding); };
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = (static_cast<double>(i) - 101.0) * 0.002;  // radians about the opposite hue
        const double hue = std::atan2(target.b, target.a) + 3.14159265358979 + turn;
        const double fy = (target.l + 16.0) / 116.0;
        row(0)[i] = static_cast<float>(fy + 5.0 * std::cos(hue) / 500.0);
        row(1)[i] = static_cast<float>(fy);
        row(2)[i] = static_cast<float>(fy - 5.0 * std::sin(hue) / 200.0);
    }
    const RootColours colours{row(0), row(1), row(2), row(3), count};
    const auto steepest = [&](double side) {
        std::vector<float> squares(count + RootColours::padding);
        many_differences(target, colours, squares.data(), side);
        double most = 0.0;
        for (std::size_t i = 1; i < count; ++i)
            most = std::max(most, std::abs(std::sqrt(static_cast<double>(squares[i])) -
                                           std::sqrt(static_cast<double>(squares[i - 1]))));
        return most;
    };
    EXPECT_GT(steepest(0.0), 1.0);
    EXPECT_LT(steepest(1.0), 0.1);
    EXPECT_LT(steepest(-1.0), 0.1);
}

TEST(CubeRoots, AreThoseOfTheLibrary) {
    std::vector<float> values{0.0F, 1.0F, 8.0F, -27.0F, 1e-6F, -1e-6F, 0.5F, 3.0e4F};
    const std::vector<float> before = values;
    values.resize(values.size() + RootColours::padding);
    cube_roots(values.data(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(values[i], std::cbrt(before[i]), 3e-7 * std::abs(std::cbrt(before[i])) + 1e-12) << before[i];
}

}  // namespace
}  // namespace nacre
