#include "nacre/fit/find_mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "nacre/colour/difference.h"
#include "nacre/fit/even_points.h"
#include "nacre/fit/shown_colours.h"
#include "nacre/fit/simplicity.h"

namespace nacre {
namespace {

constexpr Xyz d65 = xyz_from_chromaticity(d65_chromaticity);

// Free numbers by their places in their ranges, u in [0, 1].
using Design = std::vector<double>;

struct Rated {
    Design design;
    double error = 0.0;
};

bool is_better(const Rated& one, const Rated& other) {
    return one.error < other.error;
}

// Of least squares: to see where a valley leads to, and to its bottom.
constexpr int few_steps = 8;
constexpr int many_steps = 40;
// Of answers that meet the colours there are enough to choose the simplest from, at so many times what is asked for.
constexpr int enough_per_answer = 4;
// Of answers that do not, so many are tried with other whole numbers.
constexpr std::size_t most_polished = 4;

class Search {
public:
    Search(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
           const SearchEffort& effort, const std::function<void()>& after_step)
        : search_(search), solve_(solve), effort_(effort), after_step_(after_step), shown_(light, places_of(search)) {
        for (const WantedColour& wanted : search.wanted) {
            wanted_.push_back(to_lab(wanted.colour, d65));
            total_weight_ += wanted.weight;
        }
    }

    std::vector<FoundMechanism> answers() {
        std::vector<Rated> answers;
        int met = 0;
        for (const Rated& start : better_starts()) {
            answers.push_back(refined(start.design, SearchDetail::refinement));
            step();
            if (answers.back().error <= as_good_as_met && ++met >= enough_per_answer * effort_.answers) break;
        }
        std::stable_sort(answers.begin(), answers.end(), is_better);
        for (std::size_t i = 0; i < std::min(answers.size(), most_polished); ++i) polish(answers[i]);
        const auto most_judged = static_cast<std::size_t>(enough_per_answer * effort_.answers);
        if (answers.size() > most_judged) answers.resize(most_judged);
        std::vector<FoundMechanism> found;
        for (const Rated& answer : answers) found.push_back(judged(answer.design));
        return ranked(std::move(found));
    }

    FoundMechanism answer_near(const std::vector<double>& values) {
        Design design;
        for (std::size_t i = 0; i < values.size(); ++i) design.push_back(search_.free[i].place_of(values[i]));
        return judged(refined(design, SearchDetail::refinement).design);
    }

private:
    static std::vector<Geometry> places_of(const MechanismSearch& search) {
        std::vector<Geometry> places;
        for (const WantedColour& wanted : search.wanted) places.push_back(wanted.geometry);
        return places;
    }

    void step() const {
        if (after_step_) after_step_();
    }

    Mechanism mechanism_of(const Design& design) const {
        Mechanism mechanism = search_.start;
        for (std::size_t i = 0; i < design.size(); ++i) search_.free[i].set(mechanism, search_.free[i].at(design[i]));
        return mechanism;
    }

    double error_of(std::span<const Xyz> shown) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const double de00 = ciede2000(wanted_[i], to_lab(shown[i], d65));
            sum += search_.wanted[i].weight * de00 * de00;
        }
        // What is no number is no answer, and sorts last.
        return std::isfinite(sum) ? std::sqrt(sum / total_weight_) : std::numeric_limits<double>::infinity();
    }

    // The best of the table, no two of them close neighbours.
    std::vector<Rated> starts() {
        const std::size_t dimensions = search_.free.size();
        if (dimensions == 0) return {Rated{}};
        const EvenPoints points(dimensions);
        std::vector<Rated> table;
        std::vector<Xyz> shown(shown_.count());
        for (int i = 0; i < effort_.table; ++i) {
            Design design = points.at(i);
            const Mechanism mechanism = mechanism_of(design);
            shown_.at(mechanism, shown_.sampling_for(mechanism, SearchDetail::table), shown);
            table.push_back({std::move(design), error_of(shown)});
            if (i % 64 == 0) step();
        }
        std::stable_sort(table.begin(), table.end(), is_better);
        std::vector<Rated> chosen;
        for (const Rated& candidate : table) {
            if (chosen.size() >= static_cast<std::size_t>(effort_.valleys)) break;
            const bool is_near = std::any_of(chosen.begin(), chosen.end(), [&](const Rated& other) {
                return are_near(candidate.design, other.design);
            });
            if (!is_near) chosen.push_back(candidate);
        }
        return chosen;
    }

    // The starts a few steps further down their valleys, and of these the best.
    std::vector<Rated> better_starts() {
        std::vector<Rated> better = starts();
        if (search_.free.empty()) return better;
        for (Rated& start : better) {
            start = refined(start.design, SearchDetail::table);
            step();
        }
        std::stable_sort(better.begin(), better.end(), is_better);
        if (better.size() > static_cast<std::size_t>(effort_.starts))
            better.resize(static_cast<std::size_t>(effort_.starts));
        return better;
    }

    static bool are_near(const Design& one, const Design& other) {
        constexpr double near = 0.04;
        for (std::size_t i = 0; i < one.size(); ++i) {
            if (std::abs(one[i] - other[i]) > near) return false;
        }
        return true;
    }

    // Whole numbers stay; the others go where the squares are least. The solver knows no bounds: it moves angles whose
    // sines are the places.
    Rated refined(const Design& start, SearchDetail detail) {
        std::vector<std::size_t> moving;
        for (std::size_t i = 0; i < start.size(); ++i) {
            if (search_.free[i].scale != FreeScale::whole && search_.free[i].high > search_.free[i].low)
                moving.push_back(i);
        }
        Design design = start;
        const SearchSampling sampling = shown_.sampling_for(mechanism_of(start), detail);
        std::vector<Xyz> shown(shown_.count());
        const auto place = [&](std::span<const double> angles) {
            for (std::size_t i = 0; i < moving.size(); ++i) {
                const double sine = std::sin(angles[i]);
                design[moving[i]] = sine * sine;
            }
        };
        LeastSquares problem;
        problem.parameters = static_cast<int>(moving.size());
        problem.residuals = static_cast<int>(3 * shown.size());
        problem.evaluate = [&](std::span<const double> angles, std::span<double> residuals) {
            place(angles);
            shown_.at(mechanism_of(design), sampling, shown);
            for (std::size_t i = 0; i < shown.size(); ++i) {
                const Lab lab = to_lab(shown[i], d65);
                const auto parts = ciede2000_parts(wanted_[i], lab);
                const double scale = std::sqrt(search_.wanted[i].weight / total_weight_);
                for (std::size_t part = 0; part < 3; ++part) residuals[3 * i + part] = scale * parts[part];
            }
        };
        std::vector<double> angles;
        for (const std::size_t i : moving) angles.push_back(std::asin(std::sqrt(start[i])));
        if (!moving.empty()) solve_(problem, angles, detail == SearchDetail::table ? few_steps : many_steps);
        place(angles);
        shown_.at(mechanism_of(design), sampling, shown);
        return {design, error_of(shown)};
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
            Rated tried = refined(design, SearchDetail::refinement);
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

    FoundMechanism judged(const Design& design) {
        FoundMechanism found;
        found.mechanism = mechanism_of(design);
        for (std::size_t i = 0; i < design.size(); ++i) found.values.push_back(search_.free[i].at(design[i]));
        found.reached.resize(shown_.count());
        shown_.at(found.mechanism, shown_.sampling_for(found.mechanism, SearchDetail::report), found.reached);
        for (std::size_t i = 0; i < found.reached.size(); ++i)
            found.de00.push_back(ciede2000(wanted_[i], to_lab(found.reached[i], d65)));
        found.error = error_of(found.reached);
        return found;
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
    const LeastSquaresSolver& solve_;
    const SearchEffort& effort_;
    const std::function<void()>& after_step_;
    ShownColours shown_;
    std::vector<Lab> wanted_;
    double total_weight_ = 0.0;
};

}  // namespace

SearchEffort effort_for(const MechanismSearch& search) {
    struct Visitor {
        SearchEffort operator()(const Film&) const { return {1 << 14, 64, 24}; }
        SearchEffort operator()(const Stack&) const { return {1 << 16, 512, 96}; }
        SearchEffort operator()(const Crystal&) const { return {1 << 14, 192, 64}; }
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
