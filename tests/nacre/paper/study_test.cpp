#include "nacre/paper/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

namespace nacre {
namespace {

TEST(Study, TargetsAreReachedByTheNumbersThatMadeThem) {
    const StudyPainter painter;
    for (int number = 0; number < study_targets; ++number) {
        const StudyTarget target = study_target(number, painter);
        EXPECT_EQ(target.is_of_layers, number % 2 == 1);
        const StudyWay way = target.is_of_layers ? layers_way() : picks_way();
        EXPECT_EQ(picture_difference(painter.paint(way.at(target.positions)), target.picture), 0.0) << number;
    }
}

// The first slider is the first that the user moves, and upwards.
TEST(Study, ATargetOneStepBesideTheStartIsReachedInOneMoveEitherWay) {
    const StudyPainter painter;
    for (const StudyWay& way : study_ways()) {
        std::vector<double> beside = way.start();
        beside.front() += UserHabits().first_step;
        const StudyPicture target = painter.paint(way.at(beside));
        const auto difference = [&](const std::vector<double>& positions) {
            return picture_difference(painter.paint(way.at(positions)), target);
        };
        const UserOutcome user = move_sliders(way.start(), difference, study_goal);
        EXPECT_TRUE(user.is_reached) << way.name;
        EXPECT_EQ(user.moves(), 1) << way.name;
    }
}

TEST(Study, HasTheSameOutcomesAtAnyNumberOfThreads) {
    constexpr int targets = 6;
    std::vector<std::vector<StudyRun>> studies;
    for (const int threads : {1, 3}) {
        const StudyPainter painter;
        std::vector<StudyRun> runs(targets);
        std::vector<std::thread> pool;
        for (int first = 0; first < threads; ++first) {
            pool.emplace_back([&, first] {
                for (int i = first; i < targets; i += threads)
                    runs[static_cast<std::size_t>(i)] = study_run(i, painter);
            });
        }
        for (std::thread& thread : pool) thread.join();
        studies.push_back(runs);
    }
    for (std::size_t i = 0; i < targets; ++i) {
        for (std::size_t way = 0; way < 2; ++way) {
            EXPECT_EQ(studies[0][i].outcomes[way].difference, studies[1][i].outcomes[way].difference) << i;
            EXPECT_EQ(studies[0][i].outcomes[way].positions, studies[1][i].outcomes[way].positions) << i;
        }
    }
}

// Of made-up outcomes: one of two targets is reached by picks, after two moves.
TEST(Study, SummaryCountsATargetThatIsNotReachedAsBeyondAllOthers) {
    const UserOutcome reached{true, {}, {9.0, 5.0, 1.0}};
    const UserOutcome stuck{false, {}, {9.0, 8.0}};
    const std::vector<StudyRun> runs{{false, {reached, stuck}}, {false, {stuck, stuck}}, {true, {stuck, reached}}};
    const Series summary = study_summary(runs);
    ASSERT_EQ(summary.rows.size(), 4u);
    EXPECT_EQ(summary.rows[0][2], 2.0);
    EXPECT_EQ(summary.rows[0][3], 1.0);
    EXPECT_EQ(summary.rows[0][4], 2.0);
    EXPECT_TRUE(std::isnan(summary.rows[0][5]));
    EXPECT_EQ(summary.rows[3][3], 1.0);
    EXPECT_EQ(summary.rows[3][7], 1.0);
    const Series curves = study_curves(runs);
    EXPECT_EQ(curves.value(1, "picks_to_picks_share"), 0.0);
    EXPECT_EQ(curves.value(2, "picks_to_picks_share"), 0.5);
    EXPECT_EQ(curves.value(400, "layers_to_layers_de00"), 1.0);
}

}  // namespace
}  // namespace nacre
