#include "nacre/pick/objective.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "nacre/colour/colour_types.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// Steps of least squares: to estimate a local minimum, and to reach it.
constexpr int few_steps = 8;
constexpr int many_steps = 40;
// Steps from the coarse minimum to the exact one.
constexpr int last_steps = 12;
// Nodes of its own: doubled until no colour moves by more, or until there are so many times as many.
constexpr double own_nodes_de00 = 0.02;
constexpr int own_nodes_most_times = 16;

std::vector<Geometry> places_of(const MechanismSearch& search) {
    std::vector<Geometry> places;
    for (const WantedColour& wanted : search.wanted) places.push_back(wanted.geometry);
    return places;
}

}  // namespace

bool are_near(const Design& one, const Design& other) {
    constexpr double near = 0.04;
    return std::equal(one.begin(), one.end(), other.begin(),
                      [](double a, double b) { return std::abs(a - b) <= near; });
}

Objective::Objective(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve)
    : search_(search), solve_(solve), shown_(light, places_of(search)) {
    for (const WantedColour& wanted : search.wanted) {
        wanted_.push_back(to_lab(wanted.colour, d65_white));
        total_weight_ += wanted.weight;
    }
}

Mechanism Objective::mechanism_of(const Design& design) const {
    Mechanism mechanism = search_.start;
    for (std::size_t i = 0; i < design.size(); ++i) search_.free[i].set(mechanism, search_.free[i].at(design[i]));
    return mechanism;
}

std::vector<double> Objective::whole_numbers(const Design& design) const {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < design.size(); ++i) {
        if (search_.free[i].scale == FreeScale::whole) numbers.push_back(search_.free[i].at(design[i]));
    }
    return numbers;
}

Design Objective::rounded(Design design) const {
    for (std::size_t i = 0; i < design.size(); ++i) {
        const FreeNumber& number = search_.free[i];
        if (number.scale == FreeScale::whole) design[i] = number.place_of(number.at(design[i]));
    }
    return design;
}

double Objective::error_of(std::span<const Xyz> shown) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const double de00 = ciede2000(wanted_[i], to_lab(shown[i], d65_white));
        sum += search_.wanted[i].weight * de00 * de00;
    }
    // A result that is not finite is not an answer and sorts last.
    return std::isfinite(sum) ? std::sqrt(sum / total_weight_) : std::numeric_limits<double>::infinity();
}

Rated Objective::rated(const Design& design, SearchDetail detail) {
    const Mechanism mechanism = mechanism_of(design);
    std::vector<Xyz> shown(shown_.count());
    shown_.at(mechanism, shown_.sampling_for(mechanism, detail), shown);
    return {design, error_of(shown)};
}

std::vector<std::size_t> Objective::moving_numbers() const {
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < search_.free.size(); ++i) {
        const FreeNumber& number = search_.free[i];
        if (number.scale != FreeScale::whole && number.high > number.low) moving.push_back(i);
    }
    return moving;
}

void Objective::fill(std::span<const Xyz> shown, std::span<double> residuals) const {
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto parts = ciede2000_parts(wanted_[i], to_lab(shown[i], d65_white));
        const double scale = std::sqrt(search_.wanted[i].weight / total_weight_);
        for (std::size_t part = 0; part < parts.size(); ++part)
            residuals[parts.size() * i + part] = scale * parts[part];
    }
}

// The solver knows no bounds: it moves angles, and the squares of their sines are the places.
Rated Objective::descended(const Design& start, const SearchSampling& sampling, int steps) const {
    const std::vector<std::size_t> moving = moving_numbers();
    Design design = start;
    std::vector<Xyz> shown(shown_.count());
    const auto show = [&](std::span<const double> angles) {
        for (std::size_t i = 0; i < moving.size(); ++i) {
            const double sine = std::sin(angles[i]);
            design[moving[i]] = sine * sine;
        }
        shown_.at(mechanism_of(design), sampling, shown);
    };
    LeastSquares problem;
    problem.parameters = static_cast<int>(moving.size());
    problem.residuals = static_cast<int>(3 * shown.size());
    problem.evaluate = [&](std::span<const double> angles, std::span<double> residuals) {
        show(angles);
        fill(shown, residuals);
    };
    std::vector<double> angles;
    for (const std::size_t i : moving) angles.push_back(std::asin(std::sqrt(start[i])));
    if (!moving.empty()) solve_(problem, angles, steps);
    show(angles);
    return {design, error_of(shown)};
}

Rated Objective::refined(const Design& start, SearchDetail detail) {
    const Mechanism mechanism = mechanism_of(start);
    if (detail == SearchDetail::table) return descended(start, shown_.sampling_for(mechanism, detail), few_steps);
    const Rated coarse = descended(start, shown_.sampling_for(mechanism, detail), many_steps);
    // A result that only seems good must not displace a good one.
    Rated fine = rated(coarse.design, SearchDetail::report);
    constexpr double share = 0.02, converged_de00 = 0.01;
    if (std::abs(fine.error - coarse.error) < share * coarse.error + converged_de00) return fine;
    return descended(coarse.design, shown_.sampling_for(mechanism, SearchDetail::report), last_steps);
}

Rated Objective::refined_with_own_nodes(const Design& start) {
    const Mechanism mechanism = mechanism_of(start);
    const int times = converged_colours(mechanism, own_nodes_de00, own_nodes_most_times).times;
    return descended(start, shown_.sampling_for(mechanism, SearchDetail::report, times), last_steps);
}

// Many periods have resonances that are far narrower than their fringes: nodes are doubled until nothing moves.
Objective::Converged Objective::converged_colours(const Mechanism& mechanism, double converged_de00, int most_times) {
    const auto colours = [&](int times) {
        std::vector<Xyz> shown(shown_.count());
        shown_.at(mechanism, shown_.sampling_for(mechanism, SearchDetail::report, times), shown);
        return shown;
    };
    Converged converged{colours(1), 1};
    if (!samples_spectra(mechanism)) return converged;
    while (converged.times < most_times) {
        const int times = 2 * converged.times;
        std::vector<Xyz> finer = colours(times);
        double moved = 0.0;
        for (std::size_t i = 0; i < finer.size(); ++i)
            moved = std::max(moved, ciede2000(to_lab(converged.shown[i], d65_white), to_lab(finer[i], d65_white)));
        converged = {std::move(finer), times};
        if (moved <= converged_de00) break;
    }
    return converged;
}

FoundMechanism Objective::judged(const Design& design) {
    FoundMechanism found;
    found.mechanism = mechanism_of(design);
    for (std::size_t i = 0; i < design.size(); ++i) found.values.push_back(search_.free[i].at(design[i]));
    constexpr double converged_de00 = 0.002;
    constexpr int most_times = 64;
    found.reached = converged_colours(found.mechanism, converged_de00, most_times).shown;
    for (std::size_t i = 0; i < found.reached.size(); ++i)
        found.de00.push_back(ciede2000(wanted_[i], to_lab(found.reached[i], d65_white)));
    found.error = error_of(found.reached);
    return found;
}

Tolerance Objective::tolerance_of(const FoundMechanism& found) {
    constexpr int samples = 2048;  // chosen: see even_normal_points()
    std::vector<std::size_t> inexact;
    for (std::size_t i = 0; i < search_.free.size(); ++i) {
        if (search_.free[i].is_thickness) inexact.push_back(i);
    }
    const int times = converged_colours(found.mechanism, own_nodes_de00, own_nodes_most_times).times;
    const SearchSampling sampling = shown_.sampling_for(found.mechanism, SearchDetail::report, times);
    std::vector<Xyz> shown(shown_.count());
    shown_.at(found.mechanism, sampling, shown);
    std::vector<Lab> exact;
    for (const Xyz& colour : shown) exact.push_back(to_lab(colour, d65_white));
    std::vector<double> all;
    std::vector<std::vector<double>> per_colour(shown.size());
    for (const std::vector<double>& errors : even_normal_points(samples, inexact.size())) {
        Mechanism made = found.mechanism;
        for (std::size_t j = 0; j < inexact.size(); ++j) {
            const double made_nm = found.values[inexact[j]] + search_.tolerance_nm * errors[j];
            search_.free[inexact[j]].set(made, std::max(made_nm, 0.0));
        }
        shown_.at(made, sampling, shown);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            all.push_back(ciede2000(exact[i], to_lab(shown[i], d65_white)));
            per_colour[i].push_back(all.back());
        }
    }
    Tolerance tolerance{search_.tolerance_nm, shift_of(std::move(all)), {}};
    for (std::vector<double>& de00 : per_colour) tolerance.per_colour.push_back(shift_of(std::move(de00)));
    return tolerance;
}

}  // namespace nacre
