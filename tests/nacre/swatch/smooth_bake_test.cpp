// Pictures from few colours against pictures of which every colour is computed.
#include "nacre/swatch/smooth_bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/lut/bake.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/swatch/swatch_gamut.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

// What an 8-bit sRGB picture stores (IEC 61966-2-1), before it is rounded.
double code_of(double linear) {
    const double value = std::clamp(linear, 0.0, 1.0);
    return 255.0 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055);
}

double codes_between(const Xyz& one, const Xyz& other) {
    const Rgb a = linear_rec709(one), b = linear_rec709(other);
    return std::max({std::abs(code_of(a.r) - code_of(b.r)), std::abs(code_of(a.g) - code_of(b.g)),
                     std::abs(code_of(a.b) - code_of(b.b))});
}

double most_codes_off(Job job, int width, int height) {
    job.width = width;
    job.height = height;
    job.sampling = choose_sampling(job, {0.1, 1.0, 0.1, 0.0}).sampling;
    const Image<Xyz> all = bake(job), few = bake_smoothly(job);
    double most = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) most = std::max(most, codes_between(all.data()[i], few.data()[i]));
    return most;
}

Job job_with(const Mechanism& mechanism, const std::string& parameter, double from, double to) {
    Job job;
    job.material = {"material", mechanism, {}};
    job.light = test::light_of();
    job.x = default_axis(quantity_of(mechanism));
    job.y = parameter_axis(mechanism, parameter, from, to);
    return job;
}

// With kinks, where the height of a band is clamped.
TEST(SmoothBake, AStripOfAPaletteIsOffByLessThanATenthOfACode) {
    for (const Palette& palette : {test::morpho, test::beetle, test::opal})
        EXPECT_LT(most_codes_off(test::job_of(palette), 1024, 1), 0.1);
}

TEST(SmoothBake, TheColoursOfASoapFilmAreOffByLessThanAFifthOfACode) {
    Film film;
    film.index = Index(1.333);
    film.substrate = Index(1.0);
    film.thickness_nm = 400.0;
    EXPECT_LT(most_codes_off(job_with(film, "thickness_nm", 20.0, 1200.0), 300, 260), 0.2);
}

TEST(SmoothBake, TheLinesOfFewGroovesAreOffByLessThanAFifthOfACode) {
    Grating grating;
    grating.period_nm = 1000.0;
    grating.grooves = 8;
    grating.groove_length_um = 2.0;
    EXPECT_LT(most_codes_off(job_with(grating, "azimuth_deg", 0.0, 10.0), 250, 40), 0.2);
}

// So narrow that no polynomial is tried.
TEST(SmoothBake, OfAFewPixelsEachIsComputed) {
    const Job job = test::job_of(test::morpho, 30);
    const Image<Xyz> all = bake(job), few = bake_smoothly(job);
    EXPECT_TRUE(std::equal(all.begin(), all.end(), few.begin()));
}

}  // namespace
}  // namespace nacre
