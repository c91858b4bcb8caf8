// The SIMD sum on every instruction set that this machine has, down to the plainest.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <random>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"

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
            const Xyz fast = band_to_xyz(weights, {peak_nm, width_nm});
            const Xyz scalar = band_to_xyz_per_cell(weights, {peak_nm, width_nm});
            // 470 products of order 0.01 to 1, each rounded: 1e-13 leaves room for any order of summation.
            ASSERT_NEAR(fast.x, scalar.x, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
            ASSERT_NEAR(fast.y, scalar.y, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
            ASSERT_NEAR(fast.z, scalar.z, 1e-13) << hwy::TargetName(target) << " " << peak_nm << " " << width_nm;
        }
    }
    allow_instruction_sets(0);
}

}  // namespace
}  // namespace nacre
