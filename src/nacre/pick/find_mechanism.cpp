#include "nacre/pick/find_mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "nacre/pick/neighbours.h"
#include "nacre/pick/objective.h"
#include "nacre/pick/search_rows.h"
#include "nacre/pick/shown_colours.h"
#include "nacre/pick/starts.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// Enough answers that meet the colours to choose the simplest from: this many times the requested number.
constexpr int enough_per_answer = 4;
// Fewer are needed of answers that do not.
constexpr int enough_unmet_per_answer = 2;
// This many of them are tried with other whole numbers, and this many are refined with their own nodes.
constexpr std::size_t most_with_other_whole_numbers = 4;
constexpr std::size_t most_sharpened = 4;

class Search {
public:
    Search(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
           const SearchEffort& effort, const std::function<void()>& after_step)
        : search_(search), effort_(effort), after_step_(after_step), objective_(search, light, solve) {}

    std::vector<FoundMechanism> answers() {
        std::vector<Rated> answers = refined(Starts(search_, effort_, after_step_, objective_).find());
        Neighbours neighbours(search_, after_step_, objective_);
        for (std::size_t i = 0; i < std::min(answers.size(), most_with_other_whole_numbers); ++i)
            neighbours.try_whole_numbers(answers[i]);
        std::stable_sort(answers.begin(), answers.end(), is_better);
        neighbours.perturb(answers, effort_.perturbations);
        answers = neighbours.best_apart(answers, static_cast<std::size_t>(enough_per_answer * effort_.answers));
        const auto unmet = static_cast<std::ptrdiff_t>(enough_unmet_per_answer * effort_.answers);
        const auto is_unmet = [](const Rated& answer) { return answer.error > as_good_as_met; };
        if (std::ssize(answers) > unmet)
            answers.erase(std::find_if(answers.begin() + unmet, answers.end(), is_unmet), answers.end());
        for (std::size_t i = 0; i < std::min(answers.size(), most_sharpened); ++i) {
            answers[i] = objective_.refined_with_own_nodes(answers[i].design);
            step();
        }
        std::vector<FoundMechanism> found;
        for (const Rated& answer : answers) found.push_back(objective_.judged(answer.design));
        found = ranked(std::move(found));
        for (FoundMechanism& one : found) {
            if (!(search_.tolerance_nm > 0.0)) break;
            one.tolerance = objective_.tolerance_of(one);
            step();
        }
        return found;
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

    // The local minima, the best first; of those that meet the colours, no more than requested.
    std::vector<Rated> refined(const std::vector<Rated>& starts) {
        std::vector<Rated> answers;
        int met = 0;
        for (const Rated& start : starts) {
            answers.push_back(objective_.refined(start.design, SearchDetail::refinement));
            step();
            if (answers.back().error <= as_good_as_met && ++met >= enough_per_answer * effort_.answers) break;
        }
        std::stable_sort(answers.begin(), answers.end(), is_better);
        return answers;
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
    SearchEffort effort = search_row_of(search.start).effort;
    // A colour of layers with random thicknesses, or above a base, takes ten times as long.
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
