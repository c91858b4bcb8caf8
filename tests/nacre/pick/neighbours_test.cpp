#include "nacre/pick/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/pick/shown_colours.h"

namespace nacre {
namespace {

const Light& daylight() {
    static const Light light = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name(settings.illuminant);
        return make_light(settings);
    }();
    return light;
}

const LeastSquaresSolver lazy = [](const LeastSquares&, std::span<double>, int) {};

FreeNumber free_number(const char* name, double low, double high, std::function<void(Mechanism&, double)> set) {
    FreeNumber number;
    number.name = name;
    number.low = low;
    number.high = high;
    number.set = std::move(set);
    return number;
}

Layer& lamella(Mechanism& mechanism, std::size_t i) {
    return std::get<Stack>(mechanism).layers.front().layers.at(i);
}

// Five pairs of two materials; what is wanted is what the pairs show that have these numbers.
MechanismSearch pairs_search(const std::vector<double>& shown_values) {
    MechanismSearch search;
    Stack stack;
    stack.substrate = 3.0;  // from below it would be the same stack, exchanged
    stack.layers.resize(1);
    stack.layers.front().repeat = 5;
    stack.layers.front().layers.resize(2);
    search.start = stack;
    search.free = {
        free_number("film", 1.0, 2.5, [](Mechanism& m, double n) { lamella(m, 0).index = n; }),
        free_number("film_nm", 20.0, 400.0, [](Mechanism& m, double nm) { lamella(m, 0).thickness_nm = nm; }),
        free_number("gap", 1.0, 2.5, [](Mechanism& m, double n) { lamella(m, 1).index = n; }),
        free_number("gap_nm", 20.0, 400.0, [](Mechanism& m, double nm) { lamella(m, 1).thickness_nm = nm; }),
    };
    Mechanism shown = search.start;
    for (std::size_t i = 0; i < search.free.size(); ++i) search.free[i].set(shown, shown_values.at(i));
    const std::vector<Geometry> places{Incidence::from_degrees(0.0), Incidence::from_degrees(45.0)};
    ShownColours colours(daylight(), places);
    std::vector<Xyz> wanted(places.size());
    colours.at(shown, colours.sampling_for(shown, SearchDetail::report), wanted);
    for (std::size_t i = 0; i < places.size(); ++i) search.wanted.push_back({places[i], wanted[i], 1.0});
    return search;
}

Design design_of(const MechanismSearch& search, const std::vector<double>& values) {
    Design design;
    for (std::size_t i = 0; i < values.size(); ++i) design.push_back(search.free[i].place_of(values[i]));
    return design;
}

TEST(Neighbours, ExchangeWhatMayChangePlaces) {
    MechanismSearch search = pairs_search({1.1, 150.0, 1.8, 90.0});
    const Design exchanged = design_of(search, {1.8, 90.0, 1.1, 150.0});
    const std::function<void()> nothing;
    for (const bool may : {false, true}) {
        if (may) search.exchanges = {{{0, 2}, {1, 3}}};
        Objective objective(search, daylight(), lazy);
        Rated answer = objective.rated(exchanged, SearchDetail::refinement);
        ASSERT_GT(answer.error, 1.0);
        Neighbours(search, nothing, objective).try_whole_numbers(answer);
        EXPECT_EQ(answer.error < 1e-6, may) << answer.error;
    }
}

TEST(Neighbours, LeadToBetterAnswersAndKeepTheBest) {
    const MechanismSearch search = pairs_search({1.1, 150.0, 1.8, 90.0});
    int steps = 0;
    const std::function<void()> count = [&] { ++steps; };
    Objective objective(search, daylight(), lazy);
    std::vector<Rated> answers{objective.rated(design_of(search, {1.2, 130.0, 1.7, 120.0}), SearchDetail::refinement)};
    const double before = answers.front().error;
    Neighbours neighbours(search, count, objective);
    neighbours.perturb(answers, 0);
    EXPECT_EQ(answers.size(), 1u);
    neighbours.perturb(answers, 64);
    EXPECT_GT(steps, 64);
    EXPECT_LT(answers.front().error, 0.7 * before);
    EXPECT_TRUE(std::is_sorted(answers.begin(), answers.end(), is_better));
    for (const Rated& answer : answers) {
        for (const double place : answer.design) EXPECT_TRUE(place >= 0.0 && place <= 1.0) << place;
    }
}

TEST(Neighbours, OfOneValleyTheBestIsKept) {
    const MechanismSearch search = pairs_search({1.1, 150.0, 1.8, 90.0});
    const std::function<void()> nothing;
    Objective objective(search, daylight(), lazy);
    const Neighbours neighbours(search, nothing, objective);
    const std::vector<Rated> sorted{{{0.5, 0.5, 0.5, 0.5}, 1.0},
                                    {{0.5, 0.53, 0.5, 0.5}, 2.0},
                                    {{0.5, 0.6, 0.5, 0.5}, 3.0},
                                    {{0.1, 0.6, 0.5, 0.5}, 4.0}};
    const std::vector<Rated> apart = neighbours.best_apart(sorted, 2);
    ASSERT_EQ(apart.size(), 2u);
    EXPECT_EQ(apart[0].error, 1.0);
    EXPECT_EQ(apart[1].error, 3.0);
}

// Many periods of strong contrast: what a search sees between their narrow resonances is not what they show.
TEST(Objective, SharpensWithTheNodesThatAnAnswerWants) {
    MechanismSearch search = pairs_search({1.0, 400.0, 2.4, 400.0});
    std::get<Stack>(search.start).layers.front().repeat = 40;
    search.wanted[0].colour = {0.3, 0.3, 0.3};
    Objective objective(search, daylight(), lazy);
    const Design design = design_of(search, {1.0, 390.0, 2.4, 380.0});
    const double shown = objective.judged(design).error;
    const double coarse = objective.rated(design, SearchDetail::refinement).error;
    const double sharp = objective.refined_with_own_nodes(design).error;
    EXPECT_LE(std::abs(sharp - shown), 0.02);
    EXPECT_GT(std::abs(coarse - shown), 2.0 * std::abs(sharp - shown));
}

TEST(Objective, OfTheBottomOfAValleyTellsWhatTheReportSees) {
    MechanismSearch search = pairs_search({1.0, 400.0, 2.4, 400.0});
    std::get<Stack>(search.start).layers.front().repeat = 40;
    search.wanted[0].colour = {0.3, 0.3, 0.3};
    Objective objective(search, daylight(), lazy);
    double beguiled = 0.0;
    for (double film_nm = 300.0; film_nm <= 390.0; film_nm += 10.0) {
        const Design design = design_of(search, {1.0, film_nm, 2.4, 380.0});
        const double reported = objective.rated(design, SearchDetail::report).error;
        const double seen = objective.rated(design, SearchDetail::refinement).error;
        beguiled = std::max(beguiled, std::abs(seen - reported));
        EXPECT_NEAR(objective.refined(design, SearchDetail::refinement).error, reported, 1e-9);
    }
    EXPECT_GT(beguiled, 0.1);
}

// One film has a quarter of the places from 1 to 40: four designs that differ in nothing else would be four valleys.
TEST(Objective, HasOneDesignForOneWholeNumber) {
    MechanismSearch search = pairs_search({1.1, 150.0, 1.8, 90.0});
    FreeNumber films = free_number("films", 1.0, 40.0, [](Mechanism& m, double n) {
        std::get<Stack>(m).layers.front().repeat = static_cast<int>(n);
    });
    films.scale = FreeScale::whole;
    search.free.push_back(films);
    const Objective objective(search, daylight(), lazy);
    const Design one = objective.rounded({0.3, 0.4, 0.5, 0.6, 0.02}),
                 other = objective.rounded({0.3, 0.4, 0.5, 0.6, 0.2});
    EXPECT_EQ(one, other);
    EXPECT_EQ(films.at(one.back()), 1.0);
    EXPECT_EQ(one.front(), 0.3);
    EXPECT_NE(one, objective.rounded({0.3, 0.4, 0.5, 0.6, 0.3}));
}

}  // namespace
}  // namespace nacre
