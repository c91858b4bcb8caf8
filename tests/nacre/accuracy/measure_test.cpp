#include "nacre/accuracy/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "nacre/accuracy/scan.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/gamut.h"
#include "nacre/scene/readers/axis_reader.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

const Encoding encoding = test::rec709_encoding();

struct MeasuredLut {
    Job job;
    Image<Rgb> stored;
    Scan scan;

    MeasuredLut(Job a_job, PixelFormat format) : job(std::move(a_job)), stored(test::stored_lut(job, format)) {
        Trial trial(job, format, encoding, false);
        scan = scan_errors(trial);
    }
};

std::vector<Job> many_jobs() {
    Job sampled = test::job_of(test::morpho, 256);
    sampled.light = test::light_of("D65", 40);
    Job yellowish = test::job_of(test::opal, 256);
    yellowish.light = test::light_of("A");
    return {
        test::job_of(test::morpho, 64),
        test::job_of(test::beetle, 128),
        sampled,
        yellowish,
        test::job_over(test::morpho, parameter_axis(test::morpho, "peak_nm", 400.0, 700.0), 20.0, 128),
        test::job_of(test::beetle, parameter_axis(test::beetle, "width_nm", 60.0, 200.0), 32, 16),
    };
}

TEST(Measure, ReachesWhatTheScanFound) {
    int i = 0;
    for (const Job& job : many_jobs()) {
        for (const PixelFormat format : {PixelFormat::half_float, PixelFormat::single_float}) {
            const MeasuredLut lut(job, format);
            const Measured measured = measure(job, lut.stored, encoding, lut.scan.worst);
            // The scan and the reference agree on the model to 1e-9; the scan's worst points are what is measured.
            EXPECT_NEAR(measured.reached, lut.scan.largest, 0.01 * lut.scan.largest) << i;
            EXPECT_NEAR(measured.reached,
                        test::plain_error(
                            [&] {
                                Job exact = job;  // plain_error() holds against what the light samples
                                exact.light = test::light_of(job.light->settings.illuminant);
                                return exact;
                            }(),
                            lut.stored, measured.at, test::shown_scale(job)),
                        0.01 * measured.reached)
                << i;
        }
        ++i;
    }
}

TEST(Measure, WithoutSuspectsStillLooksAllOverTheLut) {
    // 96 points cannot miss most of an error that every cell shares.
    for (const Job& job : {test::job_of(test::morpho, 64),
                           test::job_of(test::beetle, parameter_axis(test::beetle, "width_nm", 60.0, 200.0), 16, 8)}) {
        const MeasuredLut lut(job, PixelFormat::single_float);
        const Measured measured = measure(job, lut.stored, encoding, {});
        EXPECT_GT(measured.reached, 0.5 * lut.scan.largest);
        EXPECT_LE(measured.reached, 1.001 * lut.scan.largest);
    }
}

TEST(Measure, SeesTheCornersWhateverTheSuspects) {
    for (const LutPoint corner : {LutPoint{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
        MeasuredLut lut(test::job_of(test::morpho, parameter_axis(test::morpho, "width_nm", 60.0, 200.0), 256, 64),
                        PixelFormat::single_float);
        Rgb& texel = lut.stored.at(corner.x == 0.0 ? 0 : 255, corner.y == 0.0 ? 0 : 63);
        texel.g += 0.5;
        const Measured measured = measure(lut.job, lut.stored, encoding, {});
        EXPECT_GT(measured.reached, 10.0);
        EXPECT_EQ(measured.at, corner);
    }
}

TEST(Measure, NoticesATexelThatIsOnePercentOff) {
    MeasuredLut lut(test::job_of(test::morpho, 1024), PixelFormat::single_float);
    const double clean = measure(lut.job, lut.stored, encoding, lut.scan.worst).reached;
    // Y of the brightest texel is 1: L* = 116 * 1 - 16 changes by 116 / 3 * 0.01 = 0.39, chroma by a third of a
    // percent; CIEDE2000 divides the first by 1.75 and the second by some 5.
    const int bright = 1000;
    Rgb& texel = lut.stored.at(bright, 0);
    texel = {1.01 * texel.r, 1.01 * texel.g, 1.01 * texel.b};
    std::vector<LutPoint> suspects = lut.scan.worst;
    suspects.insert(suspects.begin(), {bright / 1023.0, 0.0});  // the worst comes first
    const Measured measured = measure(lut.job, lut.stored, encoding, suspects);
    EXPECT_LT(clean, 0.01);
    EXPECT_GT(measured.reached, 0.1);
    EXPECT_EQ(measured.at, suspects.front());
}

TEST(Measure, NoticesWhatIsNotANumber) {
    for (const double nothing : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        MeasuredLut lut(test::job_of(test::beetle, 64), PixelFormat::half_float);
        lut.stored.at(31, 0).b = nothing;
        const Measured measured = measure(lut.job, lut.stored, encoding, {});
        EXPECT_FALSE(measured.reached <= 1e6);
        EXPECT_NEAR(measured.at.x, 31.0 / 63.0, 1.0 / 63.0);
    }
}

TEST(Measure, NoticesComponentsInTheWrongOrder) {
    MeasuredLut lut(test::job_of(test::morpho, 256), PixelFormat::half_float);
    for (Rgb& texel : lut.stored) std::swap(texel.r, texel.b);
    EXPECT_GT(measure(lut.job, lut.stored, encoding, lut.scan.worst).reached, 20.0);
}

TEST(Measure, NoticesALutThatIsUpsideDown) {
    MeasuredLut lut(test::job_of(test::morpho, parameter_axis(test::morpho, "width_nm", 60.0, 200.0), 64, 32),
                    PixelFormat::single_float);
    for (int row = 0; row < 16; ++row) {
        for (int column = 0; column < 64; ++column)
            std::swap(lut.stored.at(column, row), lut.stored.at(column, 31 - row));
    }
    EXPECT_GT(measure(lut.job, lut.stored, encoding, lut.scan.worst).reached, 5.0);
}

TEST(Measure, JudgesAGamutRuleByWhatItWasAskedToShow) {
    // Green of the beetle lies outside Rec.709. Cut at zero it is another colour, but the LUT is right: it holds the
    // cut colours, and only the filter between them errs.
    Encoding clipped = encoding;
    clipped.keeps_colours = false;
    clipped.to_rgb = [](const Image<Xyz>& image) {
        return test::converted<Rgb>(encoding.to_rgb(image), clip_to_gamut);
    };
    const Job job = test::job_of(test::beetle, 512);
    const Image<Rgb> stored = test::stored_as(clipped.to_rgb(bake(job)), PixelFormat::single_float);
    EXPECT_LT(measure(job, stored, clipped, {}).reached, 0.05);
    EXPECT_GT(measure(job, stored, encoding, {}).reached, 1.0);
}

// Three texels whose change is known from the definition: clipping shows clip_to_gamut(texel) instead of the texel.
TEST(ClippingLoss, CountsTexelsThatChangeByMoreThanTheBoundAndFindsTheLargestChange) {
    constexpr double scale = 2.0;
    const std::vector<Rgb> colours{{0.2, 0.3, 0.4}, {0.2, 0.3, -1e-5}, {0.3, 0.2, -0.02}, {-0.1, 0.4, 0.3}};
    Image<Rgb> stored(static_cast<int>(colours.size()), 1);
    std::copy(colours.begin(), colours.end(), stored.begin());
    Image<Rgb> clipped = stored;
    for (Rgb& texel : clipped) texel = clip_to_gamut(texel);
    const Image<Xyz> meant = encoding.to_xyz(stored), seen = encoding.to_xyz(clipped);
    std::vector<double> changes;
    for (int i = 0; i < stored.width(); ++i) changes.push_back(difference_at(meant.at(i, 0), seen.at(i, 0), scale));
    ASSERT_EQ(changes[0], 0.0);
    ASSERT_LT(changes[1], 0.01);
    ASSERT_LT(changes[2], changes[3]);
    EXPECT_EQ(clipping_loss(stored, encoding, scale, 0.5 * changes[1]), (ClippingLoss{3, changes[3]}));
    EXPECT_EQ(clipping_loss(stored, encoding, scale, 0.1), (ClippingLoss{2, changes[3]}));
    EXPECT_EQ(clipping_loss(stored, encoding, scale, 1.01 * changes[2]), (ClippingLoss{1, changes[3]}));
    EXPECT_EQ(clipping_loss(Image<Rgb>(4, 1, colours[0]), encoding, scale, 0.1), ClippingLoss{});
}

TEST(Measure, CountsWhatThePlanSaysItWill) {
    for (const Job& job : many_jobs()) {
        for (const std::size_t suspect_count : {std::size_t{0}, std::size_t{48}}) {
            const std::vector<LutPoint> suspects(suspect_count, LutPoint{0.25, 0.5});
            Work work;
            const Image<Xyz> texels = bake(job, {}, &work);
            work += measure(job, encoding.to_rgb(texels), encoding, suspects).work;
            EXPECT_EQ(test::without_effects(work), bake_work(job, suspect_count));
            EXPECT_EQ(work.texels, texels.size());
        }
    }
}

TEST(TestEncoding, RoundsEveryComponentToSinglePrecision) {
    const Image<Rgb> stored = test::stored_as(Image<Rgb>(5, 1, {0.1, 0.2, 0.3}), PixelFormat::single_float);
    for (const Rgb& texel : stored) EXPECT_EQ(texel, (Rgb{double{0.1F}, double{0.2F}, double{0.3F}}));
}

TEST(TestEncoding, RoundsToTheNearestHalfTiesToEven) {
    // IEEE 754-2008, binary16: 11 significant bits, the largest 65504, the smallest 2^-24.
    EXPECT_EQ(test::nearest_half(1.0 + 0x1p-11), 1.0);
    EXPECT_EQ(test::nearest_half(1.0 + 0x1.8p-10), 1.0 + 0x1p-9);
    EXPECT_EQ(test::nearest_half(-(1.0 + 0x1.00002p-11)), -(1.0 + 0x1p-10));
    EXPECT_EQ(test::nearest_half(0.1), 1638.0 / 16384.0);
    EXPECT_EQ(test::nearest_half(65519.0), 65504.0);
    EXPECT_EQ(test::nearest_half(65520.0), std::numeric_limits<double>::infinity());
    EXPECT_EQ(test::nearest_half(0x1p-25), 0.0);
    EXPECT_EQ(test::nearest_half(0x1.8p-25), 0x1p-24);
    EXPECT_EQ(test::nearest_half(0x1.ff8p-15), 0x1.ff8p-15) << "the largest subnormal";
    EXPECT_EQ(test::nearest_half(0x1.ff9p-15), 0x1.ff8p-15);
}

}  // namespace
}  // namespace nacre
