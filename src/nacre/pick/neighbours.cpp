#include "nacre/pick/neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "nacre/base/even_points.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/shown_colours.h"

namespace nacre {

void Neighbours::try_whole_numbers(Rated& answer) {
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds && answer.error > as_good_as_met; ++round) {
        const Rated better = best_neighbour(answer);
        if (!(better.error < 0.99 * answer.error)) break;
        answer = better;
    }
}

Rated Neighbours::best_neighbour(const Rated& answer) {
    Rated best = answer;
    const auto look_at = [&](const Design& design) {
        Rated tried = objective_.refined(design, SearchDetail::refinement);
        step();
        if (is_better(tried, best)) best = std::move(tried);
    };
    const auto look_along = [&](std::size_t i, double place) {
        Design design = answer.design;
        design[i] = place;
        look_at(design);
    };
    const auto value_of = [&](std::size_t i) { return search_.free[i].at(answer.design[i]); };
    for (std::size_t i = 0; i < answer.design.size(); ++i) {
        const FreeNumber& number = search_.free[i];
        if (number.scale != FreeScale::whole) {
            constexpr double end = 1e-3;
            constexpr double inside = 0.08;
            if (std::abs(answer.design[i] - 0.5) > 0.5 - end)
                look_along(i, answer.design[i] < 0.5 ? inside : 1.0 - inside);
            continue;
        }
        const double now = value_of(i);
        for (const double other : {now - 1.0, now + 1.0, std::round(0.85 * now), std::round(1.18 * now)}) {
            if (other >= number.low && other <= number.high && other != now) look_along(i, number.place_of(other));
        }
    }
    for (const FreeExchange& exchange : search_.exchanges) {
        Design design = answer.design;
        for (const auto& [one, other] : exchange) {
            design[one] = search_.free[one].place_of(value_of(other));
            design[other] = search_.free[other].place_of(value_of(one));
        }
        look_at(design);
    }
    return best;
}

std::vector<Rated> Neighbours::best_apart(const std::vector<Rated>& sorted, std::size_t count) const {
    std::vector<Rated> best;
    for (const Rated& candidate : sorted) {
        if (best.size() >= count) break;
        const bool is_near = std::any_of(best.begin(), best.end(), [&](const Rated& other) {
            return are_near(candidate.design, other.design) &&
                   objective_.whole_numbers(candidate.design) == objective_.whole_numbers(other.design);
        });
        if (!is_near) best.push_back(candidate);
    }
    return best;
}

// Perturbs two of the numbers, or one, because a perturbation of all lands anywhere. Beyond an end of the range it is
// mirrored.
Design Neighbours::perturbed(const Design& from, int number, double length) const {
    const EvenPoints points(from.size());
    const std::vector<double> point = points.at(number);
    const auto turn = static_cast<std::size_t>(number);
    Design to = from;
    for (const std::size_t i : {turn % from.size(), turn / from.size() % from.size()}) {
        const double place = std::abs(from[i] + length * (2.0 * point[i] - 1.0));
        to[i] = place > 1.0 ? 2.0 - place : place;
    }
    return to;
}

void Neighbours::perturb(std::vector<Rated>& answers, int perturbations) {
    constexpr std::size_t most_origins = 6;
    constexpr int rounds = 3;
    constexpr double first_length = 1.0, shorter = 0.7;
    if (perturbations == 0 || search_.free.empty()) return;
    int next = 0;
    double length = first_length;
    for (int round = 0; round < rounds && answers.front().error > as_good_as_met; ++round, length *= shorter) {
        const std::vector<Rated> origins = best_apart(answers, most_origins);
        std::vector<Rated> perturbed_ones;
        for (const Rated& from : origins) {
            for (int i = 0; i < perturbations; ++i) {
                perturbed_ones.push_back(objective_.refined(objective_.rounded(perturbed(from.design, next++, length)),
                                                            SearchDetail::table));
                step();
            }
        }
        std::stable_sort(perturbed_ones.begin(), perturbed_ones.end(), is_better);
        perturbed_ones.resize(std::min(perturbed_ones.size(), 2 * origins.size()));
        for (const Rated& place : perturbed_ones) {
            answers.push_back(objective_.refined(place.design, SearchDetail::refinement));
            step();
        }
        std::stable_sort(answers.begin(), answers.end(), is_better);
    }
}

}  // namespace nacre
