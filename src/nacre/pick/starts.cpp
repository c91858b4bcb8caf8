#include "nacre/pick/starts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "nacre/base/even_points.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/shown_colours.h"

namespace nacre {

// Designs all over the ranges, the best first. @param fixed  a design whose whole numbers all of them have; null: none
std::vector<Rated> Starts::table_of(int count, const Design* fixed) {
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < search_.free.size(); ++i) {
        if (fixed == nullptr || search_.free[i].scale != FreeScale::whole) moving.push_back(i);
    }
    std::vector<Rated> table;
    if (moving.empty()) return table;
    const EvenPoints points(moving.size());
    Design design = fixed == nullptr ? Design(search_.free.size()) : *fixed;
    for (int i = 0; i < count; ++i) {
        const std::vector<double> point = points.at(i);
        for (std::size_t j = 0; j < moving.size(); ++j) design[moving[j]] = point[j];
        table.push_back(objective_.rated(objective_.rounded(design), SearchDetail::table));
        if (i % 64 == 0 && after_step_) after_step_();
    }
    std::stable_sort(table.begin(), table.end(), is_better);
    return table;
}

// The best of the table, no two of them close neighbours. Half of the places are shared among all choices of whole
// numbers, because least squares cannot change those, and a design that is bad in the table may become good.
std::vector<Rated> Starts::valleys(const std::vector<Rated>& sorted, std::size_t wanted) const {
    std::map<std::vector<double>, std::vector<const Design*>> groups;
    for (const Rated& candidate : sorted) groups[objective_.whole_numbers(candidate.design)];
    const std::size_t share = std::max<std::size_t>(1, wanted / (2 * groups.size()));
    std::size_t unshared = 0;
    std::vector<Rated> chosen;
    for (const Rated& candidate : sorted) {
        if (chosen.size() >= wanted) break;
        std::vector<const Design*>& group = groups[objective_.whole_numbers(candidate.design)];
        const bool has_share = group.size() < share;
        if (!has_share && unshared >= wanted / 2) continue;
        const bool is_near = std::any_of(group.begin(), group.end(),
                                         [&](const Design* other) { return are_near(candidate.design, *other); });
        if (is_near) continue;
        group.push_back(&candidate.design);
        if (!has_share) ++unshared;
        chosen.push_back(candidate);
    }
    return chosen;
}

// A few steps down.
void Starts::follow(std::vector<Rated>& valleys) {
    for (Rated& valley : valleys) {
        valley = objective_.refined(valley.design, SearchDetail::table);
        if (after_step_) after_step_();
    }
    std::stable_sort(valleys.begin(), valleys.end(), is_better);
}

// The most promising whole numbers get a table of their own.
std::vector<Rated> Starts::deepened(const std::vector<Rated>& followed, std::size_t wanted) {
    constexpr std::size_t most_deepened = 5;
    std::vector<std::vector<double>> looked_at;
    std::vector<Rated> more;
    for (const Rated& valley : followed) {
        if (looked_at.size() >= most_deepened || valley.error <= as_good_as_met) break;
        const std::vector<double> numbers = objective_.whole_numbers(valley.design);
        if (numbers.empty() || std::find(looked_at.begin(), looked_at.end(), numbers) != looked_at.end()) continue;
        looked_at.push_back(numbers);
        std::vector<Rated> own = valleys(table_of(effort_.table / 4, &valley.design), wanted / 8);
        follow(own);
        more.insert(more.end(), own.begin(), own.end());
    }
    return more;
}

// Half of them are the best of all; the other half the best of every choice of whole numbers.
std::vector<Rated> Starts::best_of(const std::vector<Rated>& sorted, std::size_t count) const {
    if (sorted.size() <= count) return sorted;
    std::map<std::vector<double>, int> seen;
    std::vector<std::pair<int, std::size_t>> rest;  // rank among those of the same whole numbers, and place
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const int rank = seen[objective_.whole_numbers(sorted[i].design)]++;
        if (i >= count / 2) rest.emplace_back(rank, i);
    }
    std::sort(rest.begin(), rest.end());
    rest.resize(count - count / 2);
    std::vector<Rated> best(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count / 2));
    for (const auto& [rank, place] : rest) best.push_back(sorted[place]);
    std::stable_sort(best.begin(), best.end(), is_better);
    return best;
}

std::vector<Rated> Starts::find() {
    if (search_.free.empty()) return {Rated{}};
    const auto wanted = static_cast<std::size_t>(effort_.valleys);
    std::vector<Rated> followed = valleys(table_of(effort_.table, nullptr), wanted);
    follow(followed);
    const std::vector<Rated> more = deepened(followed, wanted);
    followed.insert(followed.end(), more.begin(), more.end());
    std::stable_sort(followed.begin(), followed.end(), is_better);
    return best_of(followed, static_cast<std::size_t>(effort_.starts));
}

}  // namespace nacre
