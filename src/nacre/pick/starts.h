#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/objective.h"

namespace nacre {

/// The starts of a search: the best local minima of a table of designs over the whole ranges.
class Starts {
public:
    /// All have to outlive this.
    Starts(const MechanismSearch& search, const SearchEffort& effort, const std::function<void()>& after_step,
           Objective& objective)
        : search_(search), effort_(effort), after_step_(after_step), objective_(objective) {}

    /// The best first; one without numbers where nothing is free.
    std::vector<Rated> find();

private:
    std::vector<Rated> table_of(int count, const Design* fixed);
    std::vector<Rated> valleys(const std::vector<Rated>& sorted, std::size_t wanted) const;
    void follow(std::vector<Rated>& valleys);
    std::vector<Rated> deepened(const std::vector<Rated>& followed, std::size_t wanted);
    std::vector<Rated> best_of(const std::vector<Rated>& sorted, std::size_t count) const;

    const MechanismSearch& search_;
    const SearchEffort& effort_;
    const std::function<void()>& after_step_;
    Objective& objective_;
};

}  // namespace nacre
