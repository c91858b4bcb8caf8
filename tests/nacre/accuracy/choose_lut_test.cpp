#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/accuracy/scan.h"
#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/readers/axis_reader.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

using test::requested_lut;

const Encoding encoding = test::rec709_encoding();
constexpr PixelFormat half = PixelFormat::half_float;
constexpr PixelFormat single = PixelFormat::single_float;

std::int64_t bytes_of(int width, int height, PixelFormat format) {
    return std::int64_t{width} * height * (format == half ? 6 : 12);
}
std::int64_t bytes_of(const ChosenLut& chosen) {
    return bytes_of(chosen.lut.job.width, chosen.lut.job.height, chosen.lut.format);
}

/// The largest error of a LUT of that size and format against the exact model; if above `enough`, any error above it.
double error_of(const PlannedLut& lut, int width, int height, PixelFormat format, double enough = HUGE_VAL) {
    Job job = lut.job;
    job.width = width;
    job.height = height;
    Trial trial(job, format, encoding, false);
    return scan_errors(trial, enough).largest;
}

struct Choice {
    int width = 0;
    int height = 0;
    PixelFormat format = half;
    friend bool operator==(const Choice&, const Choice&) = default;
};

Choice choice_of(const ChosenLut& chosen) {
    return {chosen.lut.job.width, chosen.lut.job.height, chosen.lut.format};
}

/// Every LUT of powers of two that has fewer bytes than a choice, or as many in half where the choice is float.
std::vector<Choice> cheaper_than(const Choice& choice, bool is_2d, const AccuracyRequest& request) {
    const std::int64_t bytes = bytes_of(choice.width, choice.height, choice.format);
    std::vector<Choice> cheaper;
    for (int width = 2; width <= (is_2d ? largest_lut_size : widest_lut_size); width *= 2) {
        for (int height = is_2d ? 2 : 1; height <= (is_2d ? largest_lut_size : 1); height *= 2) {
            for (const PixelFormat format : {half, single}) {
                if (request.width && width != *request.width) continue;
                if (request.height && height != *request.height) continue;
                if (request.format && format != *request.format) continue;
                const std::int64_t these = bytes_of(width, height, format);
                const bool is_preferred = these == bytes && format == half && choice.format == single;
                if (these < bytes || is_preferred) cheaper.push_back({width, height, format});
            }
        }
    }
    return cheaper;
}

/// That a chosen LUT keeps its bound, and no cheaper one does.
void expect_the_cheapest(PlannedLut lut, const std::string& name) {
    const double bound = lut.request.max_de00;
    const ChosenLut chosen = choose_lut(lut, encoding);
    const Choice choice = choice_of(chosen);
    ASSERT_TRUE(chosen.is_reached) << name << ' ' << bound;
    EXPECT_TRUE(chosen.limiting_factor.empty());
    const double reached = error_of(lut, choice.width, choice.height, choice.format);
    EXPECT_LE(reached, bound) << name;
    EXPECT_NEAR(chosen.predicted.total, reached, 0.1 * bound) << name;
    // A scan may miss a hundredth: what lies so near the bound may be passed over.
    const double hair = 0.975;
    for (const Choice& other : cheaper_than(choice, lut.job.y.has_value(), lut.request)) {
        EXPECT_GT(error_of(lut, other.width, other.height, other.format, hair * bound), hair * bound)
            << name << ", bound " << bound << ": " << other.width << " x " << other.height << ' '
            << (other.format == half ? "half" : "float") << " would do instead of " << choice.width << " x "
            << choice.height << ' ' << (choice.format == half ? "half" : "float");
    }
}

/// That a LUT has to keep.
AccuracyRequest bound_of(double max_de00) {
    AccuracyRequest request;
    request.max_de00 = max_de00;
    request.is_binding = true;
    return request;
}

/// None, where a scene says how its LUT is to be.
AccuracyRequest goal_of(double max_de00) {
    AccuracyRequest request;
    request.max_de00 = max_de00;
    request.has_bound = false;
    return request;
}

Job on_axis(Job job, std::string_view axis) {
    job.x.kind = &test::axis_kind(axis);
    return job;
}

Job width_plane() {
    return test::job_of(test::morpho, parameter_axis(test::morpho, "width_nm", 60.0, 160.0), 256, 64);
}

TEST(ChooseLut, TakesTheSmallestPowerOfTwoThatKeepsTheBound) {
    for (const double bound : {5.0, 1.0, 0.3, 0.1, 0.03, 0.01}) {
        expect_the_cheapest(requested_lut(test::job_of(test::morpho), bound), "morpho");
        expect_the_cheapest(requested_lut(test::job_of(test::beetle), bound), "beetle");
        expect_the_cheapest(requested_lut(on_axis(test::job_of(test::opal), "cos_theta"), bound),
                            "opal over the cosine");
        expect_the_cheapest(requested_lut(test::job_of(test::opal), bound), "opal");
    }
}

TEST(ChooseLut, OverAPlaneTakesTheFewestBytes) {
    for (const double bound : {8.0, 3.0, 1.2}) expect_the_cheapest(requested_lut(width_plane(), bound), "width");
    expect_the_cheapest(
        requested_lut(test::job_of(test::beetle, parameter_axis(test::beetle, "shape", 0.0, 1.0), 256, 64), 1.0),
        "shape");
}

TEST(ChooseLut, NeverTakesMoreBytesForALooserBound) {
    for (const Palette& palette : {test::morpho, test::beetle, test::opal}) {
        std::int64_t last = bytes_of(16384, 1, single);
        for (const double bound : {0.005, 0.007, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.2, 0.5, 1.0, 3.0, 10.0, 100.0}) {
            const ChosenLut chosen = choose_lut(requested_lut(test::job_of(palette), bound), encoding);
            EXPECT_LE(bytes_of(chosen), last) << bound;
            last = bytes_of(chosen);
        }
        EXPECT_LE(last, bytes_of(8, 1, half)) << "100 is as far as any two colours, or nearly";
    }
}

TEST(ChooseLut, HasNothingLeftOpenAndSaysWhereTheErrorIs) {
    const ChosenLut chosen = choose_lut(requested_lut(test::job_of(test::morpho), 0.1), encoding);
    ASSERT_FALSE(chosen.worst.empty());
    const Image<Rgb> stored = test::stored_lut(chosen.lut.job, chosen.lut.format);
    const double scale = test::shown_scale(chosen.lut.job);
    EXPECT_NEAR(test::plain_error(chosen.lut.job, stored, chosen.worst.front(), scale), chosen.predicted.total, 1e-6);
    // A plain scan of a hundred points per cell may miss a half percent of the largest error.
    EXPECT_NEAR(test::plain_largest_error(chosen.lut.job, stored, 100), chosen.predicted.total,
                5e-3 * chosen.predicted.total);
    EXPECT_EQ(chosen.lut.name, "lut");
    EXPECT_EQ(std::get<Palette>(chosen.lut.job.material.mechanism), test::morpho);
}

TEST(ChooseLut, NamesTheSharesOfItsError) {
    const ChosenLut chosen = choose_lut(requested_lut(test::job_of(test::beetle), 0.1), encoding);
    const Job& job = chosen.lut.job;
    const Image<Xyz> texels = bake(job);
    const Image<Xyz> stored = encoding.to_xyz(test::stored_lut(job, chosen.lut.format));
    const double scale = test::shown_scale(job);
    double storage = 0.0;
    for (std::size_t i = 0; i < texels.size(); ++i)
        storage = std::max(storage, test::shown_difference(texels.data()[i], stored.data()[i], scale));
    EXPECT_NEAR(chosen.predicted.storage, storage, 1e-9);
    const Image<Rgb> unrounded = encoding.to_rgb(texels);
    EXPECT_LE(chosen.predicted.interpolation, 1.01 * test::plain_largest_error(job, unrounded, 33) + 1e-3);
    EXPECT_GT(chosen.predicted.interpolation, 0.0);
    EXPECT_LE(chosen.predicted.total, chosen.predicted.storage + chosen.predicted.interpolation + 0.01);
    EXPECT_EQ(chosen.predicted.spectrum, 0.0) << "a palette is integrated exactly";
}

TEST(ChooseLut, KeepsToWhatTheSceneInsistsOn) {
    PlannedLut lut = requested_lut(test::job_of(test::morpho), 0.5);
    lut.request.width = 200;
    EXPECT_EQ(choice_of(choose_lut(lut, encoding)), (Choice{200, 1, half}));
    EXPECT_TRUE(choose_lut(lut, encoding).is_reached);
    lut.request.format = single;
    EXPECT_EQ(choice_of(choose_lut(lut, encoding)), (Choice{200, 1, single}));
    lut.request = bound_of(0.5);
    lut.request.format = single;
    const ChosenLut in_float = choose_lut(lut, encoding);
    EXPECT_EQ(in_float.lut.format, single);
    expect_the_cheapest(lut, "in float");

    PlannedLut plane = requested_lut(width_plane(), 3.0);
    plane.request.width = 48;
    const ChosenLut of_width = choose_lut(plane, encoding);
    EXPECT_EQ(of_width.lut.job.width, 48);
    plane.request = bound_of(3.0);
    plane.request.height = 24;
    const ChosenLut of_height = choose_lut(plane, encoding);
    EXPECT_EQ(of_height.lut.job.height, 24);
    EXPECT_TRUE(of_height.is_reached);
    EXPECT_EQ(of_height.lut.job.width & (of_height.lut.job.width - 1), 0) << "a power of two";
    plane.request = goal_of(3.0);
    plane.request.width = 5;
    plane.request.height = 7;
    plane.request.format = single;
    EXPECT_EQ(choice_of(choose_lut(plane, encoding)), (Choice{5, 7, single}));
}

TEST(ChooseLut, OfABoundThatDoesNotBindReportsWithoutComplaint) {
    PlannedLut lut = requested_lut(test::job_of(test::morpho), 0.1);
    lut.request.width = 8;
    lut.request.format = half;
    lut.request.is_binding = lut.request.has_bound = false;
    const ChosenLut chosen = choose_lut(lut, encoding);
    EXPECT_FALSE(chosen.is_reached);
    EXPECT_EQ(choice_of(chosen), (Choice{8, 1, half}));
    EXPECT_GT(chosen.predicted.total, 1.0);
    EXPECT_NEAR(chosen.predicted.total, error_of(lut, 8, 1, half), 0.01);
    EXPECT_FALSE(chosen.worst.empty());
}

/// A number as a message about an error has it: two digits.
std::string two_digits(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", value);
    return text.data();
}

TEST(ChooseLut, ThatHalfCannotReachSaysWhatHalfCostsAndToUseFloat) {
    PlannedLut lut = requested_lut(test::job_of(test::beetle), 0.02);
    lut.request.format = half;
    const ChosenLut chosen = choose_lut(lut, encoding);
    EXPECT_FALSE(chosen.is_reached);
    EXPECT_EQ(chosen.lut.format, half);
    // What the message says.
    const Job& job = chosen.lut.job;
    const Image<Xyz> stored = encoding.to_xyz(test::stored_lut(job, half));
    const Image<Xyz> meant = bake(job);
    double storage = 0.0;
    for (std::size_t i = 0; i < meant.size(); ++i)
        storage = std::max(storage, test::shown_difference(stored.data()[i], meant.data()[i], test::shown_scale(job)));
    EXPECT_EQ(chosen.limiting_factor, "half costs " + two_digits(storage) + ": use float");
    lut.request.format.reset();
    EXPECT_TRUE(choose_lut(lut, encoding).is_reached);
    EXPECT_EQ(choose_lut(lut, encoding).lut.format, single);
}

TEST(ChooseLut, ThatAFixedSizeCannotReachSaysWhatThatSizeCosts) {
    PlannedLut lut = requested_lut(test::job_of(test::morpho), 0.1);
    lut.request.width = 16;
    const ChosenLut chosen = choose_lut(lut, encoding);
    EXPECT_FALSE(chosen.is_reached);
    EXPECT_EQ(chosen.lut.job.width, 16);
    Job job = chosen.lut.job;
    const double interpolation = test::plain_largest_error(job, encoding.to_rgb(bake(job)), 400);
    EXPECT_EQ(chosen.limiting_factor, "interpolation between 16 x 1 texels costs " + two_digits(interpolation) +
                                          ": leave size out, or give a larger one");

    PlannedLut plane = requested_lut(width_plane(), 0.5);
    plane.request.width = 8;
    plane.request.height = 4;
    const ChosenLut of_plane = choose_lut(plane, encoding);
    EXPECT_FALSE(of_plane.is_reached);
    EXPECT_EQ(of_plane.limiting_factor.substr(0, 41), "interpolation between 8 x 4 texels costs ");
}

TEST(ChooseLut, ThatWavelengthsCannotReachSaysWhatTheyCost) {
    PlannedLut lut = requested_lut(test::job_of(test::morpho), 0.1);
    lut.job.light = test::light_of("D65", 20);
    const ChosenLut chosen = choose_lut(lut, encoding);
    EXPECT_FALSE(chosen.is_reached);
    const Job exact = test::job_of(test::morpho);
    double spectrum = 0.0;
    for (int i = 0; i < 65; ++i) {  // choose_lut() compares at so many points
        spectrum = std::max(spectrum, test::shown_difference(exact_xyz(lut.job, i / 64.0), exact_xyz(exact, i / 64.0),
                                                             test::shown_scale(exact)));
    }
    EXPECT_EQ(chosen.limiting_factor, "20 wavelengths cost " + two_digits(spectrum) + ": leave wavelengths out");
    EXPECT_GT(chosen.work.spectra, 0U);

    // A scene that requests its wavelengths is judged by what the LUT adds to them.
    lut.request = goal_of(0.5);
    const ChosenLut insisted = choose_lut(lut, encoding);
    EXPECT_TRUE(insisted.is_reached);
    Job sampled = insisted.lut.job;
    EXPECT_LE(test::plain_largest_error(sampled, test::stored_lut(sampled, insisted.lut.format), 100), 0.5);
    EXPECT_EQ(insisted.work.exact_integrals, 65U) << "the survey's truth; the rest samples";
}

TEST(ChooseLut, ThatNoSizeReachesSaysThatThereIsNone) {
    const ChosenLut chosen = choose_lut(requested_lut(test::job_of(test::morpho), 2e-5), encoding);
    EXPECT_FALSE(chosen.is_reached);
    EXPECT_EQ(chosen.lut.job.width, 16384) << "the best there is";
    EXPECT_EQ(chosen.lut.format, single);
    EXPECT_EQ(chosen.limiting_factor, "interpolation between 16384 x 1 texels costs " +
                                          two_digits(chosen.predicted.interpolation) +
                                          ", and 16384 texels are the most that nacre tries: give a larger bound");
}

TEST(ChooseLut, WithoutAWayBackToXyzRefusesABoundAndElseTakesDefaults) {
    Encoding one_way = encoding;
    one_way.to_xyz = nullptr;
    PlannedLut lut = requested_lut(test::job_of(test::morpho), 0.1);
    lut.request.is_binding = true;
    try {
        choose_lut(lut, one_way);
        FAIL() << "a bound that nobody can check";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "the colour space has no inverse to XYZ, so its errors cannot be measured; give [accuracy] size "
                     "instead of a bound");
    }
    lut.request.is_binding = lut.request.has_bound = false;
    const ChosenLut blind = choose_lut(lut, one_way);
    EXPECT_EQ(choice_of(blind), (Choice{256, 1, half}));
    EXPECT_FALSE(blind.is_reached);
    EXPECT_EQ(blind.work, Work{});
    PlannedLut plane = requested_lut(width_plane(), 0.1);
    plane.request.is_binding = plane.request.has_bound = false;
    EXPECT_EQ(choice_of(choose_lut(plane, one_way)), (Choice{256, 64, half}));
    plane.request = goal_of(0.1);
    plane.request.width = 100;
    plane.request.format = single;
    EXPECT_EQ(choice_of(choose_lut(plane, one_way)), (Choice{100, 64, single}));
}

TEST(ChooseLut, OfABlackMaterialIsTheSmallestLut) {
    Palette black = test::morpho;
    for (Pick& pick : black.picks) pick.lobe.height = 0.0;
    const ChosenLut line = choose_lut(requested_lut(test::job_of(black), 0.001), encoding);
    EXPECT_EQ(choice_of(line), (Choice{2, 1, half}));
    EXPECT_EQ(line.predicted.total, 0.0);
    EXPECT_TRUE(line.is_reached);
    const ChosenLut plane = choose_lut(
        requested_lut(test::job_of(black, parameter_axis(black, "width_nm", 10.0, 200.0), 256, 64), 0.001), encoding);
    EXPECT_EQ(choice_of(plane), (Choice{2, 2, half}));
    EXPECT_EQ(plane.predicted.total, 0.0);
}

TEST(ChooseLut, OfNumbersTooLargeForHalfTakesFloat) {
    // A space whose unit is a millionth of white: half ends at 65504.
    Encoding large = encoding;
    const auto times = [](double factor) {
        return [factor](const Rgb& texel) { return Rgb{factor * texel.r, factor * texel.g, factor * texel.b}; };
    };
    large.to_rgb = [=](const Image<Xyz>& image) { return test::converted<Rgb>(encoding.to_rgb(image), times(1e6)); };
    large.to_xyz = [=](const Image<Rgb>& image) { return encoding.to_xyz(test::converted<Rgb>(image, times(1e-6))); };
    const ChosenLut chosen = choose_lut(requested_lut(test::job_of(test::morpho), 0.1), large);
    EXPECT_EQ(chosen.lut.format, single);
    EXPECT_TRUE(chosen.is_reached);
    const ChosenLut usual = choose_lut(requested_lut(test::job_of(test::morpho), 0.1), encoding);
    EXPECT_EQ(chosen.lut.job.width, usual.lut.job.width);
}

TEST(ChooseLut, OfAColourThatDoesNotChangeNeedsTwoTexels) {
    const Palette constant{{{30.0, {540.0, 120.0, 0.9}}}};
    // All that it errs by is how half rounds it, 5e-4 of each component at most.
    const ChosenLut chosen = choose_lut(requested_lut(test::job_of(constant), 0.1), encoding);
    EXPECT_EQ(choice_of(chosen), (Choice{2, 1, half}));
    EXPECT_NEAR(chosen.predicted.total, chosen.predicted.storage, 1e-9);
    EXPECT_LE(chosen.predicted.interpolation, 1e-9);
    EXPECT_EQ(choice_of(choose_lut(requested_lut(test::job_of(constant), 0.001), encoding)), (Choice{2, 1, single}));
}

// The numbers below are no truth: they guard against evaluations that crept in, which nobody would see otherwise. Lower
// them when choose_lut() learns to do with fewer.
TEST(ChooseLut, TakesNoMoreEvaluationsThanItDid) {
    const auto work_of = [](std::uint64_t exact, std::uint64_t texels, std::uint64_t probes) {
        Work work;
        work.exact_integrals = exact;
        work.texels = texels;
        work.probes = probes;
        return work;
    };
    EXPECT_EQ(test::without_effects(choose_lut(requested_lut(test::job_of(test::morpho), 0.1), encoding).work),
              work_of(2833, 1087, 1746));
    EXPECT_EQ(test::without_effects(choose_lut(requested_lut(test::job_of(test::beetle), 0.01), encoding).work),
              work_of(2564, 575, 1989));
    EXPECT_EQ(test::without_effects(choose_lut(requested_lut(width_plane(), 1.0), encoding).work),
              work_of(83043, 5475, 77568));
}

}  // namespace
}  // namespace nacre
