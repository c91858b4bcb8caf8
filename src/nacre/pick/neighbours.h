#pragma once

#include <functional>
#include <vector>

#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/objective.h"

namespace nacre {

/// What least squares from a start do not find: better answers near good ones.
class Neighbours {
public:
    /// All have to outlive this.
    Neighbours(const MechanismSearch& search, const std::function<void()>& after_step, Objective& objective)
        : search_(search), after_step_(after_step), objective_(objective) {}

    /// Least squares do not move whole numbers, and at the end of a range sines stand still: neighbours in both, and
    /// exchanged parts, as long as that helps.
    void polish(Rated& answer);

    /// Leaps from the best few answers, shorter from round to round, each followed down: valleys that meet colours well
    /// lie together. @param answers  the best first, also on return @param leaps  per answer and round
    void wander(std::vector<Rated>& answers, int leaps);

    /// The first so many of which no two lie in one valley.
    std::vector<Rated> best_apart(const std::vector<Rated>& sorted, std::size_t count) const;

private:
    Rated best_neighbour(const Rated& answer);
    Design leap(const Design& from, int number, double length) const;
    void step() const {
        if (after_step_) after_step_();
    }

    const MechanismSearch& search_;
    const std::function<void()>& after_step_;
    Objective& objective_;
};

}  // namespace nacre
