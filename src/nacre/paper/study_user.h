#pragma once

#include <functional>
#include <vector>

namespace nacre {

/// How an automatic user moves sliders. Positions and steps are shares of a slider's length.
struct UserHabits {
    double first_step = 0.25;            ///< chosen: from the middle to halfway to an end
    double smallest_step = 1.0 / 512.0;  ///< chosen: a pixel of a slider of usual length
    /// CIEDE2000 by which a move must help. Chosen: far above rounding, which would otherwise decide between moves that
    /// change nothing.
    double least_gain = 1e-4;
    int most_moves = 400;  ///< chosen: more than an hour at ten seconds each
};

/// Where a user ended, and the way there.
struct UserOutcome {
    bool is_reached = false;
    std::vector<double> positions;   ///< of the best picture
    std::vector<double> difference;  ///< of the best picture so far: at the start, and after each move

    int moves() const { return static_cast<int>(difference.size()) - 1; }
};

/// Moves one slider at a time until the picture is the target's, by a pattern search (Hooke & Jeeves 1961, J. ACM 8(2),
/// 212-229, without their pattern moves): each slider in turn goes one step to one side as often as that helps, or else
/// to the other side. When no slider helps, the step is halved. The search ends when a step would be too small.
///
/// A move is one new position of one slider, whether it helps or not. Taking a useless move back is part of it.
/// @param start       positions, each in [0, 1]
/// @param difference  between the picture at some positions and the target; called once for the start and once per move
/// @param goal        a difference below this counts as reached
UserOutcome move_sliders(std::vector<double> start,
                         const std::function<double(const std::vector<double>& positions)>& difference, double goal,
                         const UserHabits& habits = {});

}  // namespace nacre
