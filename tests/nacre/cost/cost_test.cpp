#include "nacre/cost/cost.h"
#include "nacre/accuracy/exact_colour.h"
#include "nacre/cost/cost_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "nacre/lut/fetch.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/sampler.h"
#include "nacre/scene/readers/axis_reader.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

const Encoding encoding = test::rec709_encoding();

std::vector<CostCase> cases_of(const Job& job, double bound = 0.1) {
    return cost_cases(test::requested_lut(job, bound), encoding, bound);
}

std::vector<CostCase> of_family(const std::vector<CostCase>& cases, CostFamily family) {
    std::vector<CostCase> some;
    std::copy_if(cases.begin(), cases.end(), std::back_inserter(some),
                 [&](const CostCase& cost) { return cost.family == family; });
    return some;
}

double error_of(const CostCase& cost) {
    return cost_error(cost, cost.make(), encoding);
}

/// The errors of a family, by label.
std::map<std::string, double> errors_of(const std::vector<CostCase>& cases, CostFamily family) {
    std::map<std::string, double> errors;
    for (const CostCase& cost : of_family(cases, family)) errors[cost.label] = error_of(cost);
    return errors;
}

TEST(Cost, HasEveryWayOnceAndThatManyOfEachKind) {
    const std::vector<CostCase> cases = cases_of(test::job_of(test::beetle), 0.3);
    // The integral, five sums, two fits, three wavelengths.
    EXPECT_EQ(of_family(cases, CostFamily::integral).size(), 9U);
    // Six sizes, two formats, three angle axes.
    EXPECT_EQ(of_family(cases, CostFamily::fixed_size).size(), 36U);
    EXPECT_EQ(of_family(cases, CostFamily::mistake).size(), 5U);
    // Eleven bounds and the one asked for.
    EXPECT_EQ(of_family(cases, CostFamily::choice).size(), 12U);
    std::set<std::string> names;
    for (const CostCase& cost : cases) {
        names.insert(std::to_string(static_cast<int>(cost.family)) + cost.label + '|' + cost.axis + '|' + cost.format);
        EXPECT_TRUE(cost.make) << cost.label;
        EXPECT_EQ(cost.family == CostFamily::choice, cost.bound > 0.0) << cost.label;
    }
    EXPECT_EQ(names.size(), cases.size()) << "two cases by one name";
}

TEST(Cost, OfABoundThatIsOnTheListHasItOnce) {
    const std::vector<CostCase> choices = of_family(cases_of(test::job_of(test::morpho), 0.1), CostFamily::choice);
    EXPECT_EQ(choices.size(), 11U);
    EXPECT_TRUE(std::is_sorted(choices.begin(), choices.end(),
                               [](const CostCase& a, const CostCase& b) { return a.bound > b.bound; }));
}

TEST(Cost, OfThe10DegreeObserverLacksTheFitThatThereIsNot) {
    LightSettings settings;
    settings.observer = Observer::cie1964_10deg;
    Job job = test::job_of(test::morpho);
    job.light = test::light_of(settings);
    EXPECT_EQ(of_family(cases_of(job, 1.0), CostFamily::integral).size(), 8U);
}

TEST(Cost, OverAParameterHasNoOtherAxesToOffer) {
    const std::vector<CostCase> cases =
        cases_of(test::job_over(test::morpho, parameter_axis(test::morpho, "peak_nm", 420.0, 620.0), 10.0), 1.0);
    EXPECT_EQ(of_family(cases, CostFamily::fixed_size).size(), 0U);
    EXPECT_EQ(of_family(cases, CostFamily::mistake).size(), 4U);
    EXPECT_EQ(of_family(cases, CostFamily::integral).size(), 9U);
    for (const CostCase& cost : cases) EXPECT_EQ(cost.axis, "peak_nm") << cost.label;
    // The baselines get the lobe of each texel, not of the first.
    const auto errors = errors_of(cases, CostFamily::integral);
    EXPECT_LT(errors.at("1 nm sum"), 0.05);
    EXPECT_LT(errors.at("exact integral"), 0.05);
}

TEST(Cost, MakesLutsOfTheSizeAndTheBytesThatItSays) {
    for (const CostCase& cost : cases_of(test::job_of(test::beetle))) {
        const Image<Rgb> stored = cost.make();
        EXPECT_EQ(stored.width(), cost.job.width) << cost.label;
        EXPECT_EQ(stored.height(), cost.job.height) << cost.label;
        const std::size_t per_texel = cost.format == "8 bit" ? 3 : cost.format == "half" ? 6 : 12;
        EXPECT_EQ(cost.bytes, per_texel * stored.size()) << cost.label;
        if (cost.format == "8 bit") continue;
        const PixelFormat format = cost.format == "half" ? PixelFormat::half_float : PixelFormat::single_float;
        EXPECT_EQ(test::stored_as(stored, format).data()[stored.size() / 2], stored.data()[stored.size() / 2])
            << cost.label << ": numbers that " << cost.format << " holds";
        if (cost.family == CostFamily::fixed_size) {
            EXPECT_EQ(cost.label, std::to_string(cost.job.width));
        }
    }
}

TEST(Cost, EightBitsAreSrgbCodes) {
    const std::vector<CostCase> mistakes = of_family(cases_of(test::job_of(test::morpho), 1.0), CostFamily::mistake);
    const auto found =
        std::find_if(mistakes.begin(), mistakes.end(), [](const CostCase& c) { return c.format == "8 bit"; });
    ASSERT_NE(found, mistakes.end());
    for (const Rgb& texel : found->make()) {
        for (const double linear : {texel.r, texel.g, texel.b}) {
            EXPECT_GE(linear, 0.0);
            EXPECT_LE(linear, 1.0);
            // IEC 61966-2-1.
            const double code =
                255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
            // The standard's two halves meet at numbers of four digits, 3e-8 apart: 1e-5 of a code.
            EXPECT_NEAR(code, std::round(code), 1e-4);
        }
    }
}

TEST(Cost, EveryChoiceKeepsItsBoundOrSaysThatItDoesNot) {
    for (const Palette& palette : {test::beetle, test::morpho}) {
        std::size_t last_bytes = 0;
        for (const CostCase& choice : of_family(cases_of(test::job_of(palette)), CostFamily::choice)) {
            const double error = error_of(choice);
            if (choice.is_reached) {
                EXPECT_LE(error, choice.bound) << choice.label;
            }
            EXPECT_NEAR(choice.predicted, error, 0.1 * choice.bound) << choice.label;
            EXPECT_GE(choice.bytes, last_bytes) << choice.label;
            last_bytes = choice.bytes;
            EXPECT_TRUE(choice.is_reached || choice.bound < 0.01) << choice.label;
        }
    }
}

TEST(Cost, ErrorIsWhatLookingEverywhereFinds) {
    for (const CostCase& cost : cases_of(test::job_of(test::beetle))) {
        if (cost.fetch_at || cost.job.width > 64) continue;
        const Image<Rgb> stored = cost.make();
        const double largest = test::plain_largest_error(cost.job, stored, 2048 / cost.job.width);
        EXPECT_NEAR(error_of(cost), largest, 0.015 * largest) << cost.label << ' ' << cost.axis;
    }
}

TEST(Cost, MistakesErrMoreThanTheSameLutWithoutThem) {
    const auto errors = errors_of(cases_of(test::job_of(test::beetle)), CostFamily::mistake);
    const double without = errors.at("none of these");
    EXPECT_LT(without, 0.1);
    for (const auto& [label, error] : errors) {
        // The palette's lobes are polynomials in the cosine, so that axis is no mistake for every one of them.
        if (label == "none of these" || label == "cosine axis") continue;
        EXPECT_GT(error, 2.0 * without) << label;
    }
    EXPECT_GT(errors.at("5 nm sum"), 0.1);
    EXPECT_GT(errors.at("half texel missing"), 0.2);
    EXPECT_GT(errors.at("8-bit sRGB texture"), 0.5);
}

TEST(Cost, HalfATexelMissingIsTheCoordinateTakenForTheTextureCoordinate) {
    const std::vector<CostCase> mistakes = of_family(cases_of(test::job_of(test::beetle), 1.0), CostFamily::mistake);
    const auto found = std::find_if(mistakes.begin(), mistakes.end(),
                                    [](const CostCase& cost) { return cost.label == "half texel missing"; });
    ASSERT_NE(found, mistakes.end());
    const Image<Rgb> stored = found->make();
    const double scale = test::shown_scale(found->job);
    double largest = 0.0;
    for (int i = 0; i <= 20000; ++i) {
        const double x = i / 20000.0;
        const Image<Rgb> fetched(1, 1, test::sampled_as_in_opengl(stored, x, 0.5));
        const Xyz seen = encoding.to_xyz(fetched).at(0, 0);
        largest = std::max(largest, test::shown_difference(seen, exact_xyz(found->job, x), scale));
    }
    EXPECT_NEAR(error_of(*found), largest, 0.002 * largest);
}

TEST(Cost, CoarserSumsErrMoreAndThreeWavelengthsMost) {
    const auto errors = errors_of(cases_of(test::job_of(test::beetle)), CostFamily::integral);
    EXPECT_LT(errors.at("exact integral"), 0.01);
    EXPECT_LT(errors.at("1 nm sum"), errors.at("5 nm sum"));
    EXPECT_LT(errors.at("5 nm sum"), errors.at("20 nm sum"));
    EXPECT_GT(errors.at("three wavelengths"), errors.at("20 nm sum"));
    EXPECT_GT(errors.at("three wavelengths"), 5.0);
}

TEST(Cost, LargerLutsErrLessUnderEveryAxis) {
    std::map<std::string, std::vector<double>> by_axis;
    for (const CostCase& cost : of_family(cases_of(test::job_of(test::morpho)), CostFamily::fixed_size)) {
        if (cost.format == "float") by_axis[cost.axis].push_back(error_of(cost));
    }
    ASSERT_EQ(by_axis.size(), 3U);
    for (const auto& [axis, errors] : by_axis) {
        ASSERT_EQ(errors.size(), 6U);
        for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], errors[i - 1]) << axis;
    }
}

Job tilted_film() {
    Film film{Index(1.0), Index(1.45), 450.0, Index(2.2)};
    Job job;
    job.material = {"film", film, {}};
    job.material.mechanism.effects.relief.tilt_deg = 12.0;
    job.light = test::light_of();
    job.width = 256;
    return job;
}

// Deciding finds the colours of facets: a way that took them would show what deciding is worth, and none of its own
// errors.
TEST(Cost, EveryWayComputesTheColoursOfTiltedFacetsItself) {
    const std::vector<CostCase> cases = cases_of(tilted_film(), 1.0);
    const auto errors = errors_of(cases, CostFamily::integral);
    EXPECT_LT(errors.at("chosen nodes"), 0.1);
    EXPECT_LT(errors.at("1 nm sum"), 0.1);
    EXPECT_GT(errors.at("12 nodes"), 2.0 * errors.at("24 nodes"));
    EXPECT_GT(errors.at("three wavelengths"), 5.0);
}

TEST(Cost, OfATiltedPaletteHasNoBaselinesOfSingleBands) {
    Job job = test::job_of(test::beetle);
    job.material.mechanism.effects.relief.tilt_deg = 12.0;
    const std::vector<CostCase> cases = cases_of(job, 1.0);
    const auto errors = errors_of(cases, CostFamily::integral);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_LT(errors.at("exact integral"), 0.1);
}

TEST(Cost, WhatNobodyDecidesOnNeedsNoSampling) {
    for (const CostCase& cost : cases_of(test::job_of(test::morpho))) EXPECT_FALSE(cost.needs_sampling) << cost.label;
    for (const CostCase& cost : cases_of(tilted_film(), 1.0)) {
        const bool is_own = (cost.family == CostFamily::integral && cost.label != "chosen nodes") ||
                            (cost.family == CostFamily::mistake && cost.label == "5 nm sum");
        EXPECT_EQ(cost.needs_sampling, !is_own) << cost.label;
    }
}

// There the scan takes the model's colours from a curve.
TEST(Cost, ErrorOfAFilmIsWhatLookingEverywhereFinds) {
    for (const CostCase& cost : cases_of(tilted_film(), 1.0)) {
        if (cost.family != CostFamily::fixed_size || cost.job.width > 64) continue;
        const Image<Rgb> stored = cost.make();
        const double scale = test::shown_scale(cost.job);
        Sampler model(cost.job);
        double largest = 0.0;
        for (int i = 0; i <= 4096; ++i) {
            const double x = i / 4096.0;
            const Image<Rgb> fetched(1, 1, fetch(stored, {x, 0.0}));
            largest = std::max(largest, test::shown_difference(encoding.to_xyz(fetched).at(0, 0), model.at(x), scale));
        }
        // The model's own error counts too: its nodes were decided for the bound.
        EXPECT_GE(error_of(cost), 0.995 * largest) << cost.label << ' ' << cost.axis;
        EXPECT_LE(error_of(cost), 1.015 * largest + 0.08) << cost.label << ' ' << cost.axis;
    }
}

TEST(Cost, OfAPlaneKeepsItsSecondAxis) {
    const Job plane = test::job_of(test::morpho, parameter_axis(test::morpho, "width_nm", 80.0, 160.0), 256, 64);
    const std::vector<CostCase> cases = cases_of(plane, 5.0);
    const std::vector<CostCase> choices = of_family(cases, CostFamily::choice);
    const auto asked = std::find_if(choices.begin(), choices.end(), [](const CostCase& c) { return c.bound == 5.0; });
    ASSERT_NE(asked, choices.end());
    EXPECT_GT(asked->job.height, 1);
    for (const CostCase& cost : cases) {
        const bool is_asked_height = cost.job.height == asked->job.height;
        EXPECT_TRUE(is_asked_height || cost.family == CostFamily::choice) << cost.label;
    }
    EXPECT_LE(error_of(*asked), 5.0);
}

}  // namespace
}  // namespace nacre
