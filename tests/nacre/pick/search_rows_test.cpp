#include "nacre/pick/search_rows.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

Mechanism film(double thickness_nm) {
    Film film;
    film.thickness_nm = thickness_nm;
    return film;
}

Mechanism lamellae(int films, double film_nm, double gap_nm) {
    Layer film, gap, group;
    film.thickness_nm = film_nm;
    gap.thickness_nm = gap_nm;
    group.repeat = films;
    group.layers = {film, gap};
    Stack stack;
    stack.layers = {group};
    return stack;
}

Mechanism crystal(int planes, double diameter_nm) {
    Crystal crystal;
    crystal.planes = planes;
    crystal.diameter_nm = diameter_nm;
    return crystal;
}

TEST(Complexity, GrowsWithNanometres) {
    EXPECT_LT(complexity_of(film(100.0)), complexity_of(film(101.0)));
    EXPECT_LT(complexity_of(lamellae(5, 100.0, 50.0)), complexity_of(lamellae(5, 100.0, 60.0)));
    EXPECT_LT(complexity_of(crystal(5, 200.0)), complexity_of(crystal(5, 210.0)));
    Grating shallow, deep;
    shallow.depth_nm = 50.0;
    deep.depth_nm = 200.0;
    EXPECT_LT(complexity_of(shallow), complexity_of(deep));
    deep.period_nm = 500.0;
    EXPECT_GT(complexity_of(shallow), complexity_of(deep));
}

TEST(Complexity, CountsLayersFirst) {
    EXPECT_LT(complexity_of(lamellae(2, 300.0, 300.0)), complexity_of(lamellae(20, 30.0, 30.0)));
    EXPECT_LT(complexity_of(lamellae(3, 80.0, 80.0)), complexity_of(lamellae(4, 80.0, 80.0)));
    EXPECT_LT(complexity_of(crystal(3, 200.0)), complexity_of(crystal(4, 200.0)));
}

TEST(Complexity, OfRepeatsIsThatOfTheLayersWrittenOut) {
    Layer film, gap;
    film.thickness_nm = 70.0;
    gap.thickness_nm = 110.0;
    Stack stack;
    stack.layers = {film, gap, film, gap, film, gap};
    EXPECT_DOUBLE_EQ(complexity_of(stack), complexity_of(lamellae(3, 70.0, 110.0)));
    EXPECT_DOUBLE_EQ(complexity_of(stack), 6 * 100.0 + 3 * 180.0);
    // Thickness runs from the first to the last of a graded group: its mean counts.
    auto graded = std::get<Stack>(lamellae(3, 70.0, 110.0));
    graded.layers[0].layers[0].last_thickness_nm = 90.0;
    EXPECT_DOUBLE_EQ(complexity_of(graded), 6 * 100.0 + 3 * (80.0 + 110.0));
}

}  // namespace
}  // namespace nacre
