#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/scene/readers/axis_reader.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

const Encoding encoding = test::rec709_encoding();

Trial trial_of(const Job& job, PixelFormat format) {
    return {job, format, encoding, false};
}

TEST(Scan, OfAModelThatIsLinearInTheCoordinateFindsNothing) {
    for (const int width : {2, 5, 64}) {
        const Job job = test::job_over(test::opal, parameter_axis(test::opal, "height", 0.0, 1.0), 20.0, width);
        Trial trial = trial_of(job, PixelFormat::single_float);
        const Scan scan = scan_errors(trial);
        // Single precision rounds to 6e-8; CIEDE2000 makes up to 1000 times that of it where it is steepest, near
        // black.
        EXPECT_LT(scan.largest, 6e-5) << width;
        EXPECT_TRUE(scan.is_complete);
        EXPECT_LT(scan_errors(trial, HUGE_VAL, {}, true).largest, 1e-10) << "before it was rounded";
    }
}

TEST(Scan, OfABlackLutFindsNothing) {
    Palette black = test::morpho;
    for (Pick& pick : black.picks) pick.lobe.height = 0.0;
    Trial trial = trial_of(test::job_of(black), PixelFormat::half_float);
    EXPECT_EQ(scan_errors(trial).largest, 0.0);
}

struct Judged {
    std::string name;
    Job job;
    PixelFormat format;
    int per_cell;  // of the search that the scan is held against
};

Job on_axis(Job job, std::string_view axis) {
    job.x.kind = &test::axis_kind(axis);
    return job;
}

constexpr PixelFormat half = PixelFormat::half_float;
constexpr PixelFormat single = PixelFormat::single_float;

/// Forty times as fine as the scan looks for a start: 8 points a cell, or 2048 over a small LUT.
std::vector<Judged> along_a_line() {
    return {
        {"morpho", test::job_of(test::morpho, 64), single, 1320},
        {"morpho of two texels", test::job_of(test::morpho, 2), single, 80000},
        {"morpho in half", test::job_of(test::morpho, 256), half, 360},
        {"beetle, clamped from 60 degrees on", test::job_of(test::beetle, 50), single, 1680},
        {"beetle over the angle", on_axis(test::job_of(test::beetle, 37), "theta_deg"), single, 2280},
        {"opal over the cosine", on_axis(test::job_of(test::opal, 100), "cos_theta"), half, 840},
        // Clamping begins 0.47 of the way through a cell, as far from any sixteenth as can be.
        {"beetle, large", test::job_of(test::beetle, 334), single, 320},
        {"opal, large", test::job_of(test::opal, 400), single, 320},
        {"a peak that moves through the spectrum",
         test::job_over(test::morpho, parameter_axis(test::morpho, "peak_nm", 380.0, 720.0), 15.0, 90), single, 960},
    };
}

std::vector<Judged> over_a_plane() {
    Palette tall = test::morpho;  // at the normal clamped as soon as its second pick is low
    tall.picks[0].angle_deg = 20.0;
    tall.picks[0].lobe.height = 0.97;
    return {
        {"width", test::job_of(test::morpho, parameter_axis(test::morpho, "width_nm", 20.0, 200.0), 12, 6), single, 60},
        {"shape", test::job_of(test::opal, parameter_axis(test::opal, "shape", 0.0, 1.0), 16, 4), half, 60},
        {"beetle, clamped", test::job_of(test::beetle, parameter_axis(test::beetle, "peak_nm", 420.0, 650.0), 9, 9),
         single, 50},
        {"clamped on a curve", test::job_of(tall, parameter_axis(tall, "picks[1].height", 0.3, 0.9), 14, 5), single,
         60},
    };
}

void expect_the_largest(const Judged& judged) {
    Trial trial = trial_of(judged.job, judged.format);
    const Scan scan = scan_errors(trial);
    const double largest =
        test::plain_largest_error(judged.job, test::stored_lut(judged.job, judged.format), judged.per_cell);
    EXPECT_NEAR(scan.largest, largest, 0.015 * largest) << judged.name;
    EXPECT_GT(largest, 1e-3) << judged.name << " errs by nothing";
    EXPECT_TRUE(scan.is_complete);
}

TEST(Scan, FindsTheLargestErrorAlongALine) {
    for (const Judged& judged : along_a_line()) expect_the_largest(judged);
}

TEST(Scan, FindsTheLargestErrorOverAPlane) {
    for (const Judged& judged : over_a_plane()) expect_the_largest(judged);
}

TEST(Scan, SaysWhereTheErrorIsTheWorstFirst) {
    std::vector<Judged> all = along_a_line();
    for (const Judged& judged : over_a_plane()) all.push_back(judged);
    for (const Judged& judged : all) {
        Trial trial = trial_of(judged.job, judged.format);
        const Scan scan = scan_errors(trial);
        const Image<Rgb> stored = test::stored_lut(judged.job, judged.format);
        const double scale = test::shown_scale(judged.job);
        const auto error = [&](LutPoint point) { return test::plain_error(judged.job, stored, point, scale); };
        // Two roads to one number: rounding of 1e-16, up to 1000 times that in L*a*b*, of differences up to 100.
        const double slack = 1e-11;
        ASSERT_FALSE(scan.worst.empty()) << judged.name;
        EXPECT_NEAR(error(scan.at), scan.largest, slack) << judged.name;
        EXPECT_NEAR(error(scan.worst.front()), scan.largest, slack) << judged.name;
        for (std::size_t i = 1; i < scan.worst.size(); ++i)
            EXPECT_LE(error(scan.worst[i]), error(scan.worst[i - 1]) + slack) << judged.name << ' ' << i;
        EXPECT_GT(error(scan.worst.back()), 0.5 * scan.largest) << judged.name;
    }
}

TEST(Scan, MissesAKinkOnAnAxisOfTheMaterialByASixteenthAtMost) {
    // A height that is clamped from some value of the axis on: the colour is linear on either side, so all of the error
    // is a triangle over one cell. No landmark stands there. The nearest of 16 steps is at most half a step away, which
    // costs a sixteenth of a triangle whose tip is in the middle of the cell.
    const Palette palette{{{20.0, {460.0, 70.0, 0.6}}, {60.0, {420.0, 60.0, 0.8}}}, 0.3};
    for (int i = 0; i < 24; ++i) {
        const Job job =
            test::job_over(palette, parameter_axis(palette, "picks[1].height", 0.5, 0.9 + 0.004 * i), 90.0, 512);
        Trial trial = trial_of(job, single);
        const double found = scan_errors(trial).largest;
        const auto is_clamped = [&](double x) {
            const Palette there = std::get<Palette>(mechanism_at(job, x, 0.0));
            return palette_lobe_unclamped(there, Incidence::from_degrees(90.0)).height > 1.0;
        };
        double kink = 1.0;
        double before = 0.0;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (before + kink);
            (is_clamped(middle) ? kink : before) = middle;
        }
        const double largest =
            test::plain_error(job, test::stored_lut(job, single), {kink, 0.0}, test::shown_scale(job));
        EXPECT_GT(found, largest * (1.0 - 1.0 / 15.0)) << i;
        EXPECT_LT(found, largest * 1.001) << i;
    }
}

TEST(Scan, StopsAtTheFirstErrorAboveTheLimit) {
    for (const Judged& judged : {along_a_line()[0], over_a_plane()[0]}) {
        Trial whole = trial_of(judged.job, judged.format);
        const Scan complete = scan_errors(whole);
        Trial part = trial_of(judged.job, judged.format);
        const Scan cut = scan_errors(part, 0.5 * complete.largest);
        EXPECT_FALSE(cut.is_complete);
        EXPECT_GT(cut.largest, 0.5 * complete.largest);
        EXPECT_LT(part.work().probes, whole.work().probes);

        const Trial untouched = trial_of(judged.job, judged.format);
        EXPECT_EQ(untouched.work().probes, 0U);
        Trial warned = trial_of(judged.job, judged.format);
        const std::vector<LutPoint> first{{0.0, 0.0}, complete.at};
        const Scan at_once = scan_errors(warned, 0.99 * complete.largest, first);
        EXPECT_FALSE(at_once.is_complete);
        EXPECT_EQ(at_once.at, complete.at);
        EXPECT_EQ(warned.work().probes, 2U) << "nothing but the points that it was told of";

        Trial within = trial_of(judged.job, judged.format);
        const Scan enough = scan_errors(within, 1.0001 * complete.largest);
        EXPECT_TRUE(enough.is_complete);
        EXPECT_EQ(enough.largest, complete.largest);
    }
}

TEST(Scan, OfWhatIsNotANumberIsAnErrorWithoutBound) {
    const Job job = test::job_of(test::morpho, 64);
    Image<Rgb> stored = test::stored_lut(job, half);
    stored.at(40, 0).g = std::numeric_limits<double>::quiet_NaN();
    Trial trial(job, stored, encoding, {});
    EXPECT_EQ(scan_errors(trial).largest, HUGE_VAL);
    EXPECT_FALSE(scan_errors(trial, 1.0).is_complete);
}

TEST(Scan, OfNumbersBeforeTheyWereRoundedSeesTheFilterAlone) {
    // Of many texels half costs much more than the filter between them does.
    const Job job = test::job_of(test::beetle, 1024);
    Trial in_half = trial_of(job, half);
    Trial in_float = trial_of(job, single);
    const double rounded = scan_errors(in_half).largest;
    const double unrounded = scan_errors(in_half, HUGE_VAL, {}, true).largest;
    EXPECT_GT(rounded, 3.0 * unrounded);
    EXPECT_NEAR(unrounded, scan_errors(in_float).largest, 1e-4) << "float rounds by next to nothing";
}

TEST(Scan, OfAShaderThatFetchesElsewhereSeesWhatItFetches) {
    // Half a texel missing: the shader takes the coordinate for the texture coordinate.
    const Job job = test::job_of(test::morpho, 64);
    const Image<Rgb> stored = test::stored_lut(job, half);
    Trial wrong(job, stored, encoding, [](LutPoint point) {
        return LutPoint{std::clamp((point.x * 64.0 - 0.5) / 63.0, 0.0, 1.0), point.y};
    });
    const double scale = test::shown_scale(job);
    double largest = 0.0;
    for (int i = 0; i <= 20000; ++i) {
        const double x = i / 20000.0;
        const Image<Rgb> fetched(1, 1, test::sampled_as_in_opengl(stored, x, 0.5));
        largest =
            std::max(largest, test::shown_difference(encoding.to_xyz(fetched).at(0, 0), exact_xyz(job, x), scale));
    }
    EXPECT_NEAR(scan_errors(wrong).largest, largest, 0.015 * largest);
}

void expect_coordinates(std::vector<double> found, std::vector<double> expected) {
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    // What lies at one place is one landmark.
    const auto is_same = [](double a, double b) { return b - a < 1e-12; };
    expected.erase(std::unique(expected.begin(), expected.end(), is_same), expected.end());
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(Breakpoints, ArePicksAndTheBeginningOfClampingOnTheAxis) {
    // The beetle: picks at 10 and 60 degrees, clamped beyond 60.
    const double cos_10 = std::cos(10.0 * std::numbers::pi / 180.0);
    const Job job = test::job_of(test::beetle);
    expect_coordinates(breakpoints(job, 0.0), {std::sqrt(cos_10), std::sqrt(0.5), std::sqrt(0.5)});
    expect_coordinates(breakpoints(on_axis(job, "cos_theta"), 0.0), {cos_10, 0.5, 0.5});
    expect_coordinates(breakpoints(on_axis(job, "theta_deg"), 0.0), {10.0 / 90.0, 60.0 / 90.0, 60.0 / 90.0});
}

TEST(Breakpoints, MoveWithTheSecondAxis) {
    // Height 0.73 at 10 degrees and h at 60; with p = 0, Y is the cosine, and the line through both meets 1 at
    // cos 10 + (1 - 0.73) / (h - 0.73) * (1/2 - cos 10).
    Palette palette = test::beetle;
    palette.shape = 0.0;
    Job job = test::job_of(palette, parameter_axis(palette, "picks[1].height", 0.7, 1.0), 8, 8);
    job.x.kind = &test::axis_kind("cos_theta");
    const double cos_10 = std::cos(10.0 * std::numbers::pi / 180.0);
    for (const double y : {0.9, 1.0}) {
        const double h = 0.7 + 0.3 * y;
        expect_coordinates(breakpoints(job, y), {cos_10, 0.5, cos_10 + 0.27 / (h - 0.73) * (0.5 - cos_10)});
    }
    expect_coordinates(breakpoints(job, 0.0), {cos_10, 0.5});
}

TEST(Breakpoints, AreNotOnAnAxisOfTheMaterial) {
    EXPECT_TRUE(
        breakpoints(test::job_over(test::beetle, parameter_axis(test::beetle, "height", 0.0, 1.0), 70.0), 0.0).empty());
}

}  // namespace
}  // namespace nacre
