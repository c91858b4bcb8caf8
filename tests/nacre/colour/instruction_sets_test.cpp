// The SIMD sum, and CIEDE2000 side by side, on every instruction set that this machine has, down to the plainest.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <random>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/pick/lobe/many_differences.h"

namespace nacre {
namespace {

// Lets the dispatcher choose among these alone; 0 restores all.
void allow_instruction_sets(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(InstructionSets, EveryOneOfThemGivesTheExactIntegral) {
    const TristimulusWeights weights =
        make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("FL11"), 380, 780);
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    EXPECT_GE(targets.size(), 1u);
    for (const std::int64_t target : targets) {
        allow_instruction_sets(target);
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> peak(300.0, 900.0);
        std::uniform_real_distribution<double> log_width(std::log(4.0), std::log(5000.0));
        for (int i = 0; i < 3000; ++i) {
            const double peak_nm = peak(generator);
            const double width_nm = std::exp(log_width(generator));
            const Xyz fast = lobe_to_xyz(weights, peak_nm, width_nm, 1.0);
            const Xyz scalar = lobe_to_xyz_per_cell(weights, peak_nm, width_nm, 1.0);
            // 470 products of order 0.01 to 1, each rounded: 1e-13 leaves room for any order of summation.
            ASSERT_NEAR(fast.x, scalar.x, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
            ASSERT_NEAR(fast.y, scalar.y, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
            ASSERT_NEAR(fast.z, scalar.z, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
        }
    }
    allow_instruction_sets(0);
}

// 33 colours: no whole number of registers on any set.
TEST(InstructionSets, EveryOneOfThemGivesCiede2000) {
    constexpr std::size_t count = 33;
    const Lab target = to_lab({0.2, 0.25, 0.6}, d65_white);
    for (const std::int64_t instruction_set : hwy::SupportedAndGeneratedTargets()) {
        allow_instruction_sets(instruction_set);
        std::vector<float> x(count + RootColours::padding, 1.0F), y(x), z(x), factor(x), squares(x);
        std::vector<Xyz> colours;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = static_cast<double>(i) / count;
            colours.push_back({0.1 + 0.3 * t, 0.2 + 0.2 * t * t, 0.7 - 0.3 * t});
            x[i] = static_cast<float>(colours[i].x / d65_white.x);
            y[i] = static_cast<float>(colours[i].y);
            z[i] = static_cast<float>(colours[i].z / d65_white.z);
        }
        for (std::vector<float>* row : {&x, &y, &z}) cube_roots(row->data(), count);
        many_differences(target, {x.data(), y.data(), z.data(), factor.data(), count}, squares.data());
        for (std::size_t i = 0; i < count; ++i) {
            const double expected = ciede2000(target, to_lab(colours[i], d65_white));
            EXPECT_NEAR(std::sqrt(squares[i]), expected, 1e-3 * expected)
                << hwy::TargetName(instruction_set) << " " << i;
        }
    }
    allow_instruction_sets(0);
}

}  // namespace
}  // namespace nacre
