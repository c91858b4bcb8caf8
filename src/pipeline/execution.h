#pragma once

#include <cstddef>
#include <functional>

namespace nacre {

/// Calls function(i) for every i in [0, count), in any order and from as many threads as it has, and returns when all
/// calls have returned. What a call throws is thrown on; then some calls may not have been made.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& function)>;

/// The ForEach of a front end without threads.
inline void for_each_in_turn(std::size_t count, const std::function<void(std::size_t)>& function) {
    for (std::size_t i = 0; i < count; ++i) function(i);
}

/// How long work runs: who spreads it over threads, who may stop it, and who is told how far it is.
struct Execution {
    ForEach for_each = for_each_in_turn;
    /// Called often and from every thread; what it throws ends the work. May be empty.
    std::function<void()> step{};
    /// Called after each piece of work, from every thread. May be empty.
    std::function<void(std::size_t done, std::size_t total)> progress{};

    void may_stop() const {
        if (step) step();
    }
    void tell(std::size_t done, std::size_t total) const {
        if (progress) progress(done, total);
    }
};

}  // namespace nacre
