#include "nacre/paper/study_user.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace nacre {
namespace {

using SliderDifference = std::function<double(const std::vector<double>&)>;

// Moves one slider in steps to one side, as long as that helps. Returns whether it did at all.
bool move_aside(UserOutcome& user, std::size_t slider, double step, const SliderDifference& difference, double goal,
                const UserHabits& habits) {
    bool helped = false;
    while (!user.is_reached && user.moves() < habits.most_moves) {
        const double from = user.positions[slider];
        const double to = std::clamp(from + step, 0.0, 1.0);
        if (to == from) break;
        user.positions[slider] = to;
        const double best = user.difference.back();
        const double found = difference(user.positions);
        user.is_reached = found < goal;
        if (!user.is_reached && found > best - habits.least_gain) {
            user.positions[slider] = from;
            user.difference.push_back(best);
            break;
        }
        user.difference.push_back(found);
        helped = true;
    }
    return helped;
}

}  // namespace

UserOutcome move_sliders(std::vector<double> start, const SliderDifference& difference, double goal,
                         const UserHabits& habits) {
    UserOutcome user;
    user.positions = std::move(start);
    user.difference = {difference(user.positions)};
    user.is_reached = user.difference.back() < goal;
    // The side to which each slider went last: it is tried first.
    std::vector<double> sides(user.positions.size(), 1.0);
    double step = habits.first_step;
    while (!user.is_reached && user.moves() < habits.most_moves && step >= habits.smallest_step) {
        bool helped = false;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            if (move_aside(user, i, sides[i] * step, difference, goal, habits)) {
                helped = true;
            } else if (move_aside(user, i, -sides[i] * step, difference, goal, habits)) {
                helped = true;
                sides[i] = -sides[i];
            }
        }
        if (!helped) step /= 2.0;
    }
    return user;
}

}  // namespace nacre
