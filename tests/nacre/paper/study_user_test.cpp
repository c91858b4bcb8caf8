#include "nacre/paper/study_user.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nacre {
namespace {

// The distance to (0.6, 0.3), in units in which a slider is 100 long.
double distance(const std::vector<double>& positions) {
    return 100.0 * std::hypot(positions[0] - 0.6, positions[1] - 0.3);
}

TEST(StudyUser, ReachesATargetBesideTheStartInFewMoves) {
    const UserOutcome user = move_sliders({0.6, 0.3 + 0.25 + 0.005}, distance, 1.0);
    EXPECT_TRUE(user.is_reached);
    // The first slider to either side, in vain; the second upwards, in vain, and downwards.
    EXPECT_EQ(user.moves(), 4);
    EXPECT_NEAR(user.positions[1], 0.305, 1e-15);
}

TEST(StudyUser, MovesNothingWhereItStartsAtTheTarget) {
    const UserOutcome user = move_sliders({0.6, 0.3}, distance, 1.0);
    EXPECT_TRUE(user.is_reached);
    EXPECT_EQ(user.moves(), 0);
}

TEST(StudyUser, CountsEachNewPictureAsOneMoveOfOneSlider) {
    std::vector<std::vector<double>> seen;
    const UserOutcome user = move_sliders(
        {0.5, 0.5},
        [&](const std::vector<double>& positions) {
            seen.push_back(positions);
            return distance(positions);
        },
        1.0);
    ASSERT_TRUE(user.is_reached);
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(user.moves()) + 1);
    EXPECT_EQ(seen.back(), user.positions);
    std::vector<double> kept = seen.front();
    for (std::size_t move = 1; move < seen.size(); ++move) {
        const int changed = (seen[move][0] != kept[0] ? 1 : 0) + (seen[move][1] != kept[1] ? 1 : 0);
        EXPECT_EQ(changed, 1) << move;
        if (distance(seen[move]) < distance(kept)) kept = seen[move];
        EXPECT_EQ(user.difference[move], distance(kept)) << move;
    }
}

TEST(StudyUser, StaysOnTheSlidersAndGivesUpWhereNothingHelps) {
    UserHabits habits;
    const UserOutcome user = move_sliders(
        {0.5},
        [](const std::vector<double>& positions) {
            EXPECT_GE(positions[0], 0.0);
            EXPECT_LE(positions[0], 1.0);
            return 10.0 + positions[0];
        },
        1.0, habits);
    EXPECT_FALSE(user.is_reached);
    EXPECT_EQ(user.positions[0], 0.0);
    EXPECT_LT(user.moves(), habits.most_moves);
}

TEST(StudyUser, MakesNoMoreMovesThanItMay) {
    UserHabits habits;
    habits.most_moves = 5;
    const UserOutcome user = move_sliders({0.0, 1.0}, distance, 1e-3, habits);
    EXPECT_FALSE(user.is_reached);
    EXPECT_EQ(user.moves(), 5);
}

}  // namespace
}  // namespace nacre
