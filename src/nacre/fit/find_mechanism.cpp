#include "nacre/fit/find_mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "nacre/fit/even_points.h"
#include "nacre/fit/objective.h"
#include "nacre/fit/simplicity.h"

namespace nacre {
namespace {

// Of answers that meet the colours there are enough to choose the simplest from, at so many times what is asked for.
constexpr int enough_per_answer = 4;
// So many choices of whole numbers are looked at again, each by itself.
constexpr std::size_t most_deepened = 5;
// Of answers that do not, so many are tried with other whole numbers.
constexpr std::size_t most_polished = 4;

class Search {
public:
    Search(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
           const SearchEffort& effort, const std::function<void()>& after_step)
        : search_(search), effort_(effort), after_step_(after_step), objective_(search, light, solve) {}

    std::vector<FoundMechanism> answers() {
        std::vector<Rated> answers;
        int met = 0;
        for (const Rated& start : starts()) {
            answers.push_back(objective_.refined(start.design, SearchDetail::refinement));
            step();
            if (answers.back().error <= as_good_as_met && ++met >= enough_per_answer * effort_.answers) break;
        }
        std::stable_sort(answers.begin(), answers.end(), is_better);
        for (std::size_t i = 0; i < std::min(answers.size(), most_polished); ++i) polish(answers[i]);
        const auto most_judged = static_cast<std::size_t>(enough_per_answer * effort_.answers);
        if (answers.size() > most_judged) answers.resize(most_judged);
        std::vector<FoundMechanism> found;
        for (const Rated& answer : answers) found.push_back(objective_.judged(answer.design));
        return ranked(std::move(found));
    }

    FoundMechanism answer_near(const std::vector<double>& values) {
        Design design;
        for (std::size_t i = 0; i < values.size(); ++i) design.push_back(search_.free[i].place_of(values[i]));
        return objective_.judged(objective_.refined(design, SearchDetail::refinement).design);
    }

private:
    void step() const {
        if (after_step_) after_step_();
    }

    // Designs all over the ranges, the best first. @param fixed  a design whose whole numbers all of them have; null:
    // none
    std::vector<Rated> table_of(int count, const Design* fixed) {
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
            table.push_back(objective_.rated(design, SearchDetail::table));
            if (i % 64 == 0) step();
        }
        std::stable_sort(table.begin(), table.end(), is_better);
        return table;
    }

    // The best of the table, no two of them close neighbours. Every choice of whole numbers has its share of half of
    // them: least squares cannot change those, and what looks bad in a table may end well.
    std::vector<Rated> valleys(const std::vector<Rated>& sorted, std::size_t wanted) const {
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
    void follow(std::vector<Rated>& valleys) {
        for (Rated& valley : valleys) {
            valley = objective_.refined(valley.design, SearchDetail::table);
            step();
        }
        std::stable_sort(valleys.begin(), valleys.end(), is_better);
    }

    // Where to begin in earnest, the best first.
    std::vector<Rated> starts() {
        if (search_.free.empty()) return {Rated{}};
        const auto wanted = static_cast<std::size_t>(effort_.valleys);
        std::vector<Rated> followed = valleys(table_of(effort_.table, nullptr), wanted);
        follow(followed);
        // The most promising whole numbers have a table of their own.
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
        followed.insert(followed.end(), more.begin(), more.end());
        std::stable_sort(followed.begin(), followed.end(), is_better);
        return best_of(followed, static_cast<std::size_t>(effort_.starts));
    }

    // Half of them are the best of all; the other half the best of every choice of whole numbers.
    std::vector<Rated> best_of(const std::vector<Rated>& sorted, std::size_t count) const {
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

    static bool are_near(const Design& one, const Design& other) {
        constexpr double near = 0.04;
        for (std::size_t i = 0; i < one.size(); ++i) {
            if (std::abs(one[i] - other[i]) > near) return false;
        }
        return true;
    }

    // What least squares do not: whole numbers do not move, and at the end of a range sines stand still. The best
    // answers are tried with neighbours, as long as that helps.
    void polish(Rated& answer) {
        constexpr int most_rounds = 8;
        for (int round = 0; round < most_rounds && answer.error > as_good_as_met; ++round) {
            const Rated better = best_neighbour(answer);
            if (!(better.error < 0.99 * answer.error)) break;
            answer = better;
        }
    }

    Rated best_neighbour(const Rated& answer) {
        Rated best = answer;
        const auto look_at = [&](std::size_t i, double place) {
            Design design = answer.design;
            design[i] = place;
            Rated tried = objective_.refined(design, SearchDetail::refinement);
            step();
            if (is_better(tried, best)) best = std::move(tried);
        };
        for (std::size_t i = 0; i < answer.design.size(); ++i) {
            const FreeNumber& number = search_.free[i];
            if (number.scale != FreeScale::whole) {
                constexpr double end = 1e-3;
                constexpr double inside = 0.08;
                if (std::abs(answer.design[i] - 0.5) > 0.5 - end)
                    look_at(i, answer.design[i] < 0.5 ? inside : 1.0 - inside);
                continue;
            }
            const double now = number.at(answer.design[i]);
            for (const double other : {now - 1.0, now + 1.0, std::round(0.85 * now), std::round(1.18 * now)}) {
                if (other >= number.low && other <= number.high && other != now) look_at(i, number.place_of(other));
            }
        }
        return best;
    }

    bool are_alike(const FoundMechanism& one, const FoundMechanism& other) const {
        constexpr double alike = 0.05;  // of the range
        for (std::size_t i = 0; i < one.values.size(); ++i) {
            const FreeNumber& number = search_.free[i];
            if (std::abs(one.values[i] - other.values[i]) > alike * (number.high - number.low)) return false;
        }
        return true;
    }

    std::vector<FoundMechanism> ranked(std::vector<FoundMechanism> found) const {
        std::stable_sort(found.begin(), found.end(),
                         [](const FoundMechanism& a, const FoundMechanism& b) { return a.error < b.error; });
        std::vector<FoundMechanism> kept;
        for (FoundMechanism& one : found) {
            const bool is_known = std::any_of(kept.begin(), kept.end(),
                                              [&](const FoundMechanism& other) { return are_alike(one, other); });
            if (!is_known) kept.push_back(std::move(one));
        }
        std::stable_sort(kept.begin(), kept.end(), [](const FoundMechanism& a, const FoundMechanism& b) {
            const double error_a = std::max(a.error, as_good_as_met);
            const double error_b = std::max(b.error, as_good_as_met);
            return error_a != error_b ? error_a < error_b : complexity_of(a.mechanism) < complexity_of(b.mechanism);
        });
        if (kept.size() > static_cast<std::size_t>(effort_.answers))
            kept.resize(static_cast<std::size_t>(effort_.answers));
        return kept;
    }

    const MechanismSearch& search_;
    const SearchEffort& effort_;
    const std::function<void()>& after_step_;
    Objective objective_;
};

}  // namespace

SearchEffort effort_for(const MechanismSearch& search) {
    struct Visitor {
        SearchEffort operator()(const Film&) const { return {1 << 14, 64, 24}; }
        SearchEffort operator()(const Stack&) const { return {1 << 16, 1536, 160}; }
        SearchEffort operator()(const Crystal&) const { return {1 << 14, 384, 96}; }
        SearchEffort operator()(const Grating&) const { return {1 << 14, 256, 48}; }
        SearchEffort operator()(const Palette&) const { return {}; }
        SearchEffort operator()(const Scatter&) const { return {}; }
        SearchEffort operator()(const MeasuredSpectra&) const { return {}; }
    };
    SearchEffort effort = std::visit(Visitor{}, static_cast<const MechanismModel&>(search.start));
    // A colour of layers that are uneven, or above a base, takes ten times as long.
    if (is_irregular(search.start) || search.start.effects.base) effort.table /= 8;
    // Two free numbers are found in a smaller table than six.
    constexpr std::size_t few_dimensions = 10;
    effort.table = std::min(effort.table, 1 << std::min<std::size_t>(few_dimensions + 2 * search.free.size(), 20));
    return effort;
}

std::vector<FoundMechanism> find_mechanisms(const MechanismSearch& search, const Light& light,
                                            const LeastSquaresSolver& solve, const SearchEffort& effort,
                                            const std::function<void()>& after_step) {
    return Search(search, light, solve, effort, after_step).answers();
}

FoundMechanism refine_mechanism(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
                                const std::vector<double>& values) {
    const SearchEffort effort;
    const std::function<void()> nothing;
    return Search(search, light, solve, effort, nothing).answer_near(values);
}

}  // namespace nacre
