#include "nacre/pick/find_mechanism.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/illuminant.h"
#include "nacre/shade/prepared_colour.h"

// What the search does around its solver, with a solver that does nothing. The rest is in tests/io.
namespace nacre {
namespace {

Light daylight() {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    return make_light(settings);
}

MechanismSearch soap_search() {
    MechanismSearch search;
    Film film;
    film.index = 1.33;
    film.thickness_nm = 300.0;
    search.start = film;
    search.wanted = {{Incidence::from_degrees(0.0), {0.05, 0.06, 0.1}, 1.0},
                     {Incidence::from_degrees(45.0), {0.04, 0.03, 0.08}, 3.0}};
    return search;
}

FreeNumber thickness() {
    FreeNumber number;
    number.name = "thickness_nm";
    number.low = 50.0;
    number.high = 1500.0;
    number.set = [](Mechanism& m, double value) { std::get<Film>(m).thickness_nm = value; };
    return number;
}

const LeastSquaresSolver lazy = [](const LeastSquares&, std::span<double>, int) {};

TEST(FindMechanisms, WithoutFreeNumbersJudgesTheStart) {
    const MechanismSearch search = soap_search();
    const auto found = find_mechanisms(search, daylight(), lazy, effort_for(search));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].mechanism, search.start);
    ASSERT_EQ(found[0].de00.size(), 2u);
    const double one = found[0].de00[0], other = found[0].de00[1];
    EXPECT_NEAR(found[0].error, std::sqrt((one * one + 3.0 * other * other) / 4.0), 1e-12);
}

TEST(FindMechanisms, HasTheBestOfItsTableWithoutASolver) {
    MechanismSearch search = soap_search();
    search.free = {thickness()};
    const Light light = daylight();
    const auto found = find_mechanisms(search, light, lazy, effort_for(search));
    ASSERT_FALSE(found.empty());
    EXPECT_LE(found.size(), 5u);
    // No thickness of a plain scan is much better.
    double best = 1e9;
    for (double nm = 50.0; nm <= 1500.0; nm += 2.0) {
        MechanismSearch fixed = soap_search();
        std::get<Film>(fixed.start).thickness_nm = nm;
        best = std::min(best, find_mechanisms(fixed, light, lazy, {}).front().error);
    }
    EXPECT_LT(found.front().error, best + 0.5);
    for (const FoundMechanism& one : found) {
        ASSERT_EQ(one.values.size(), 1u);
        EXPECT_EQ(std::get<Film>(one.mechanism).thickness_nm, one.values[0]);
    }
}

TEST(FindMechanisms, NamesNumbersInRangeWhateverTheSolverDoes) {
    MechanismSearch search = soap_search();
    search.free = {thickness()};
    const LeastSquaresSolver wild = [](const LeastSquares&, std::span<double> parameters, int) {
        for (double& parameter : parameters) parameter += 1000.3;
    };
    for (const FoundMechanism& found : find_mechanisms(search, daylight(), wild, effort_for(search))) {
        EXPECT_GE(found.values[0], 50.0);
        EXPECT_LE(found.values[0], 1500.0);
    }
}

TEST(FindMechanisms, EndsWhenItsCallbackThrows) {
    MechanismSearch search = soap_search();
    search.free = {thickness()};
    struct Stop {};
    int steps = 0;
    EXPECT_THROW(find_mechanisms(search, daylight(), lazy, effort_for(search),
                                 [&] {
                                     if (++steps == 5) throw Stop{};
                                 }),
                 Stop);
    EXPECT_EQ(steps, 5);
}

TEST(FoundText, SaysTheNumbers) {
    MechanismSearch search;
    FreeNumber number = thickness();
    search.free = {number};
    FoundMechanism found;
    found.values = {402.12345};
    EXPECT_EQ(found_text(search, found), "thickness_nm = 402.12");
    EXPECT_EQ(found_text({}, {}), "nothing was free");
}

}  // namespace
}  // namespace nacre
