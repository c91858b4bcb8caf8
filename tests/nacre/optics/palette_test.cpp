#include "nacre/optics/palette.h"

#include <gtest/gtest.h>

#include <numbers>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/number.h"
#include "reference/paper_palette.h"

namespace nacre {
namespace {

using reference::Number;

const Pick morpho_normal{0.0, {460.0, 70.0, 1.0}}, morpho_oblique{40.0, {395.0, 60.0, 0.7}};
const Palette morpho{{morpho_normal, morpho_oblique}};
const Palette beetle{{{10.0, {530.0, 110.0, 0.73}}, {60.0, {460.0, 110.0, 1.0}}}};

Palette with_shape(Palette palette, double shape) {
    palette.shape = shape;
    return palette;
}

Lobe lobe_at(const Palette& palette, double theta_deg) {
    return palette_lobe_unclamped(palette, Incidence::from_degrees(theta_deg));
}

reference::PaperPick paper(const Pick& pick) {
    return {pick.angle_deg, pick.lobe.peak_nm, pick.lobe.width_nm, pick.lobe.height};
}

reference::LobeNumbers paper_lobe(const Palette& palette, const Number& cos_theta) {
    return reference::paper_lobe(paper(palette.picks.at(0)), paper(palette.picks.at(1)), palette.shape, cos_theta);
}

/// Difference over the larger of the number and of what the picks span: what rounding can be held to where a straight
/// line crosses 0.
double error_of(double number, const Number& exact, double pick_1, double pick_2) {
    const Number scale = std::max<Number>(abs(exact), Number(std::max(std::abs(pick_1), std::abs(pick_2))));
    return static_cast<double>(abs(Number(number) - exact) / scale);
}

double error_of(const Lobe& lobe, const reference::LobeNumbers& exact, const Palette& palette) {
    const Lobe& one = palette.picks.at(0).lobe;
    const Lobe& two = palette.picks.at(1).lobe;
    const double error = std::max({error_of(lobe.peak_nm, exact.peak_nm, one.peak_nm, two.peak_nm),
                                   error_of(lobe.width_nm, exact.width_nm, one.width_nm, two.width_nm),
                                   error_of(lobe.height, exact.height, one.height, two.height)});
    const bool is_number = std::isfinite(lobe.peak_nm + lobe.width_nm + lobe.height);
    return is_number ? error : std::numeric_limits<double>::infinity();
}

void expect_near(const Lobe& lobe, const Lobe& expected, double relative) {
    EXPECT_NEAR(lobe.peak_nm, expected.peak_nm, relative * expected.peak_nm);
    EXPECT_NEAR(lobe.width_nm, expected.width_nm, relative * 100.0);  // widths may cross 0
    EXPECT_NEAR(lobe.height, expected.height, relative);
}

TEST(Palette, PassesThroughItsPicks) {
    for (const double shape : {0.0, 0.5, Palette::default_shape, 1.0}) {
        for (const Palette& palette : {with_shape(morpho, shape), with_shape(beetle, shape)}) {
            for (const Pick& pick : palette.picks) {
                // A pick is what the user sees in his scene: it comes back as it was typed, to the bit.
                EXPECT_EQ(lobe_at(palette, pick.angle_deg), pick.lobe) << pick.angle_deg;
                EXPECT_EQ(palette_lobe(palette, Incidence::from_degrees(pick.angle_deg)), pick.lobe);
            }
        }
    }
}

TEST(Palette, IsThePapersFormulasIn50Digits) {
    const Palette gentle{{{5.0, {650.0, 200.0, 0.2}}, {85.0, {420.0, 90.0, 0.6}}}};
    for (const double shape : {0.0, 0.3, Palette::default_shape, 1.0}) {
        for (const Palette& material : {morpho, beetle, gentle}) {
            const Palette palette = with_shape(material, shape);
            for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 0.37) {
                const Number cos_theta = reference::cos_of_degrees(theta_deg);
                // Some ten roundings, magnified by no more than the extrapolation, below 5 for these picks.
                EXPECT_LT(error_of(lobe_at(palette, theta_deg), paper_lobe(palette, cos_theta), palette), 1e-14)
                    << "shape " << shape << " at " << theta_deg;
            }
        }
    }
}

TEST(Palette, AlongTheSquareRootAxisIsThePapersFormulasIn50Digits) {
    for (const Palette& palette : {morpho, beetle}) {
        for (int i = 0; i <= 256; ++i) {
            const double root = i / 256.0;
            const Lobe lobe = palette_lobe_unclamped(palette, Incidence::from_sqrt_cos(root));
            EXPECT_LT(error_of(lobe, paper_lobe(palette, Number(root) * root), palette), 1e-14) << root;
        }
    }
}

TEST(Palette, PicksAtNearlyEqualAnglesKeepTheirDigits) {
    // 1e-6 degrees apart, so that the lobe runs away by up to 1e15 times the difference of the picks; the digits stay.
    // Differences of the doubles that the angles are lose nothing, so ten roundings remain here too.
    for (const double shape : {0.0, Palette::default_shape, 1.0}) {
        for (const auto& [low, high] : {std::pair{0.0, 1e-6}, {1e-6, 2e-6}, {40.0, 40.0 + 1e-6}, {89.999999, 90.0}}) {
            const Palette palette{{{low, {460.0, 70.0, 1.0}}, {high, {395.0, 60.0, 0.7}}}, shape};
            std::vector<double> angles{0.0, 1e-7, 1e-6, 1.0, 40.0, 40.0 + 5e-7, 70.0, 89.9999999, 90.0};
            angles.insert(angles.end(), {low, high, 0.5 * (low + high), low + 0.3 * (high - low)});
            for (const double theta_deg : angles) {
                const Number cos_theta = reference::cos_of_degrees(theta_deg);
                EXPECT_LT(error_of(lobe_at(palette, theta_deg), paper_lobe(palette, cos_theta), palette), 1e-14)
                    << low << " and " << high << ", shape " << shape << ", at " << theta_deg;
            }
        }
    }
}

TEST(Palette, DifferenceOfShapesKeepsItsDigitsNearTheNormalAndNearGrazing) {
    for (const double shape : {0.0, 0.3, Palette::default_shape, 1.0}) {
        for (const auto& [a, b] :
             {std::pair{0.0, 1e-6}, {1e-8, 3e-8}, {0.0, 90.0}, {30.0, 30.0 + 1e-9}, {90.0, 89.9}}) {
            const Number exact = reference::paper_shape(shape, reference::cos_of_degrees(a)) -
                                 reference::paper_shape(shape, reference::cos_of_degrees(b));
            const double difference = shape_difference(shape, Incidence::from_degrees(a), Incidence::from_degrees(b));
            // Two sines, two products, a sum of terms of one sign.
            EXPECT_LT(reference::relative_distance(difference, exact), 2e-15) << shape << ' ' << a << ' ' << b;
        }
    }
}

TEST(Palette, EqualPeaksAreNoSpecialCase) {
    // Where the paper divides by 0: the limit of ever closer peaks is what the formulas without the division say.
    const Palette equal{{{0.0, {500.0, 70.0, 1.0}}, {40.0, {500.0, 30.0, 0.4}}}};
    Palette nearly = equal;
    nearly.picks[1].lobe.peak_nm = std::nextafter(500.0, 501.0);
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 7.5) {
        const reference::LobeNumbers exact = paper_lobe(nearly, reference::cos_of_degrees(theta_deg));
        const Lobe lobe = lobe_at(equal, theta_deg);
        EXPECT_EQ(lobe.peak_nm, 500.0) << theta_deg;
        EXPECT_LT(reference::distance(lobe.width_nm, exact.width_nm), 70.0 * 1e-14) << theta_deg;
        EXPECT_LT(reference::distance(lobe.height, exact.height), 1e-14) << theta_deg;
    }
}

TEST(Palette, PicksThatAreEqualMakeAConstantMaterial) {
    const Lobe lobe{500.0, 70.0, 0.4};
    for (const Palette& palette :
         {Palette{{{30.0, lobe}}}, Palette{{{30.0, lobe}, {30.0, lobe}}}, Palette{{{0.0, lobe}, {40.0, lobe}}},
          Palette{{{0.0, lobe}, {0.0, lobe}, {9.0, lobe}}}}) {
        for (const double theta_deg : {0.0, 30.0, 60.0, 90.0})
            EXPECT_EQ(lobe_at(palette, theta_deg), lobe) << theta_deg;
    }
}

TEST(Palette, OrderOfThePicksDoesNotMatter) {
    const Pick third{70.0, {380.0, 80.0, 0.9}};
    const Palette sorted{{morpho_normal, morpho_oblique, third}}, shuffled{{third, morpho_normal, morpho_oblique}};
    const Palette reversed{{morpho_oblique, morpho_normal}};
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 7.5) {
        EXPECT_EQ(lobe_at(shuffled, theta_deg), lobe_at(sorted, theta_deg)) << theta_deg;
        EXPECT_EQ(lobe_at(reversed, theta_deg), lobe_at(morpho, theta_deg)) << theta_deg;
    }
}

TEST(Palette, PicksOnOneLineAreTheLine) {
    Palette several = morpho;
    for (const double angle_deg : {12.0, 30.0, 65.0}) several.picks.push_back({angle_deg, lobe_at(morpho, angle_deg)});
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 0.5) {
        // The picks between are rounded to doubles and the extrapolation from 65 degrees at most doubles that.
        expect_near(lobe_at(several, theta_deg), lobe_at(morpho, theta_deg), 1e-14);
    }
}

TEST(Palette, OfManyPicksPassesThroughEachAndNeverOvershoots) {
    reference::Uniform uniform(5);
    for (int material = 0; material < 200; ++material) {
        Palette palette{{}, uniform.between(0.0, 1.0)};
        double angle_deg = uniform.between(0.0, 10.0);
        while (angle_deg <= 90.0 && palette.picks.size() < 8) {
            palette.picks.push_back(
                {angle_deg, {uniform.between(380.0, 780.0), uniform.between(10.0, 200.0), uniform.between(0.0, 1.0)}});
            angle_deg += std::pow(10.0, uniform.between(-3.0, 1.5));
        }
        for (std::size_t i = 0; i < palette.picks.size(); ++i) {
            EXPECT_EQ(lobe_at(palette, palette.picks[i].angle_deg), palette.picks[i].lobe);
            if (i == 0) continue;
            const Pick& one = palette.picks[i - 1];
            const Pick& two = palette.picks[i];
            double progress = -1e-13;  // monotone up to rounding
            for (int step = 0; step <= 50; ++step) {
                const double t = step / 50.0;
                const Lobe lobe = lobe_at(palette, (1.0 - t) * one.angle_deg + t * two.angle_deg);
                const auto share = [](double at, double from, double to) { return (at - from) / (to - from); };
                const double peak = share(lobe.peak_nm, one.lobe.peak_nm, two.lobe.peak_nm);
                const double width = share(lobe.width_nm, one.lobe.width_nm, two.lobe.width_nm);
                const double height = share(lobe.height, one.lobe.height, two.lobe.height);
                // Rounding of a number over the distance of two random ones, seldom below a thousandth of it.
                for (const double s : {peak, width, height}) EXPECT_TRUE(s > -1e-10 && s < 1.0 + 1e-10) << s;
                EXPECT_GE(peak, progress - 1e-10);
                progress = peak;
            }
        }
    }
}

TEST(Palette, OfThreePicksHasNoKinkAtTheMiddleOne) {
    const Palette palette{{morpho_normal, morpho_oblique, {70.0, {380.0, 80.0, 0.9}}}};
    const auto slope_of_peak = [&](double from_deg, double to_deg) {
        return (lobe_at(palette, to_deg).peak_nm - lobe_at(palette, from_deg).peak_nm) / (to_deg - from_deg);
    };
    // Differences over 1e-4 degrees: the curvature, below 1 nm per degree squared, moves a slope by 1e-4.
    EXPECT_NEAR(slope_of_peak(40.0 - 1e-4, 40.0), slope_of_peak(40.0, 40.0 + 1e-4), 1e-3);
    EXPECT_LT(slope_of_peak(40.0 - 1e-4, 40.0), -0.1);  // and it is a slope, not a stop
}

TEST(Palette, BeyondManyPicksGoesOnAsTheNearestTwoPoint) {
    const Pick third{70.0, {380.0, 80.0, 0.9}}, fourth{80.0, {390.0, 20.0, 0.1}};
    const Palette four{{morpho_oblique, {50.0, {420.0, 75.0, 0.8}}, third, fourth}};
    const Palette first_two{{four.picks[0], four.picks[1]}}, last_two{{third, fourth}};
    for (double theta_deg = 0.0; theta_deg < 40.0; theta_deg += 2.5) {
        expect_near(lobe_at(four, theta_deg), lobe_at(first_two, theta_deg),
                    1e-13);  // t is as small as -4: ten roundings
    }
    for (double theta_deg = 80.0; theta_deg <= 90.0; theta_deg += 0.5) {
        expect_near(lobe_at(four, theta_deg), lobe_at(last_two, theta_deg), 1e-13);
    }
}

/// Largest distance from the Bragg law over 0-90 degrees, as a fraction of the peak at the normal, of two picks that
/// lie on the law at 20 and 60 degrees, where the best straight line in Y crosses it.
double worst_misfit_to_bragg(double index, double shape) {
    const auto bragg = [index](double theta_deg) {
        const double sine = static_cast<double>(sin(reference::radians(Number(theta_deg)))) / index;
        return std::sqrt((1.0 - sine) * (1.0 + sine));
    };
    const Palette palette{{{20.0, {500.0 * bragg(20.0), 70.0, 1.0}}, {60.0, {500.0 * bragg(60.0), 70.0, 1.0}}}, shape};
    double worst = 0.0;
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 0.5) {
        worst = std::max(worst, std::abs(lobe_at(palette, theta_deg).peak_nm / 500.0 - bragg(theta_deg)));
    }
    return worst;
}

TEST(Palette, DefaultShapeFollowsTheBraggLawOfChitinWithinTwoThousandths) {
    EXPECT_LT(worst_misfit_to_bragg(1.56, Palette::default_shape), 2e-3);
    EXPECT_GT(worst_misfit_to_bragg(1.56, Palette::default_shape - 0.02), 2e-3);
    EXPECT_GT(worst_misfit_to_bragg(1.56, Palette::default_shape + 0.02), 2e-3);
}

// With p = 0, Y is cos(theta): picks at cosines 1, 0.8 and 0.2 are 0.2 and 0.6 apart, and nothing is symmetric.
TEST(Palette, SlopeAtAnInnerPickIsTheWeightedHarmonicMeanOfItsSecants) {
    const auto degrees = [](double cosine) { return std::acos(cosine) * 180.0 / std::numbers::pi; };
    const Palette palette{{{0.0, {500, 100, 0.5}}, {degrees(0.8), {480, 100, 0.5}}, {degrees(0.2), {360, 100, 0.5}}},
                          0.0};
    // Secants in Y = cos(theta): 20 / 0.2 = 100 and 120 / 0.6 = 200. Fritsch & Butland, steps h1 = 0.2 and h2 = 0.6:
    // (3 h1 + 3 h2) / ((2 h2 + h1) / 100 + (h2 + 2 h1) / 200) = 2.4 / (0.014 + 0.005) = 126.3157...
    const double slope = 2.4 / 0.019;
    const double step = 1e-6;
    const double at = palette_lobe(palette, Incidence::from_cos(0.8)).peak_nm;
    const double above = palette_lobe(palette, Incidence::from_cos(0.8 + step)).peak_nm;
    const double below = palette_lobe(palette, Incidence::from_cos(0.8 - step)).peak_nm;
    EXPECT_NEAR(at, 480.0, 1e-9);
    // One-sided differences of a cubic with a second derivative of order 1e3.
    EXPECT_NEAR((above - at) / step, slope, 0.01);
    EXPECT_NEAR((at - below) / step, slope, 0.01);
}

}  // namespace
}  // namespace nacre
