#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/objective.h"

namespace nacre {

/// Better answers near good ones, which least squares from a start do not find.
class Neighbours {
public:
    /// All have to outlive this.
    Neighbours(const MechanismSearch& search, const std::function<void()>& after_step, Objective& objective)
        : search_(search), after_step_(after_step), objective_(objective) {}

    /// Least squares do not change whole numbers, nor numbers at the end of a range, where the derivative of a sine is
    /// 0. This tries neighbours in both, and exchanged parts, as long as the error falls.
    void try_whole_numbers(Rated& answer);

    /// Perturbs the best few answers, less from round to round, and refines each result (basin hopping): good local
    /// minima lie close together. @param answers  the best first, also on return @param perturbations  per answer and
    /// round
    void perturb(std::vector<Rated>& answers, int perturbations);

    /// The first answers, up to a number, of which no two are near the same local minimum.
    std::vector<Rated> best_apart(const std::vector<Rated>& sorted, std::size_t count) const;

private:
    Rated best_neighbour(const Rated& answer);
    Design perturbed(const Design& from, int number, double length) const;
    void step() const {
        if (after_step_) after_step_();
    }

    const MechanismSearch& search_;
    const std::function<void()>& after_step_;
    Objective& objective_;
};

}  // namespace nacre
