#include "nacre/optics/refractive_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "reference/csv.h"

namespace nacre {
namespace {

// Fraunhofer's lines, nm.
constexpr double c_line = 656.2725, d_line = 587.5618, f_line = 486.1327;

const IndexFormula schott_n_bk7{2, {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653}};
const IndexFormula malitson_silica{1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161}};

SampledCurve table(std::vector<double> nm, std::vector<double> value) {
    return {std::move(nm), std::move(value)};
}

TEST(IndexFormula, GivesNBk7AsSchottPrintsIt) {
    // SCHOTT's data sheet of N-BK7 517642.251: n_d, n_F, n_C to five digits, Abbe's number to two.
    EXPECT_NEAR(schott_n_bk7.at(d_line), 1.51680, 5e-6);
    EXPECT_NEAR(schott_n_bk7.at(f_line), 1.52238, 5e-6);
    EXPECT_NEAR(schott_n_bk7.at(c_line), 1.51432, 5e-6);
    const double dispersion = schott_n_bk7.at(f_line) - schott_n_bk7.at(c_line);
    EXPECT_NEAR((schott_n_bk7.at(d_line) - 1.0) / dispersion, 64.17, 5e-3);
}

TEST(IndexFormula, GivesFusedSilicaAsMalitsonPrintsIt) {
    // Malitson 1965, J. Opt. Soc. Am. 55, 1205: n_d = 1.45846 and V = 67.8.
    EXPECT_NEAR(malitson_silica.at(d_line), 1.45846, 5e-6);
    const double dispersion = malitson_silica.at(f_line) - malitson_silica.at(c_line);
    EXPECT_NEAR((malitson_silica.at(d_line) - 1.0) / dispersion, 67.8, 0.05);
}

TEST(IndexFormula, GivesAirAndDiamondToTheirKnownDigits) {
    const IndexFormula air{6, {0, 0.05792105, 238.0185, 0.00167917, 57.362}};  // Ciddor 1996
    EXPECT_NEAR(air.at(589.3), 1.000277, 5e-7);
    const IndexFormula diamond{1, {0, 0.3306, 0.1750, 4.3356, 0.1060}};  // Peter 1923
    EXPECT_NEAR(diamond.at(589.3), 2.417, 5e-4);
}

TEST(IndexFormula, IsTheSumThatItsNumberStandsFor) {
    // Written out for one set of coefficients at 0.5 um; roots to the last bits, and different coefficients throughout,
    // so that none can stand for another.
    const double l2 = 0.25;
    const auto n = [](int number, std::vector<double> c) { return IndexFormula{number, std::move(c)}.at(500.0); };
    EXPECT_NEAR(n(1, {0.1, 0.7, 0.2, 0.3, 0.1}), std::sqrt(1.1 + 0.7 * l2 / (l2 - 0.04) + 0.3 * l2 / (l2 - 0.01)),
                1e-15);
    EXPECT_NEAR(n(2, {0.1, 0.7, 0.2, 0.3, 0.1}), std::sqrt(1.1 + 0.7 * l2 / (l2 - 0.2) + 0.3 * l2 / (l2 - 0.1)), 1e-15);
    EXPECT_NEAR(n(3, {2.0, 0.3, 2, 0.01, -4}), std::sqrt(2.0 + 0.3 * 0.25 + 0.01 * 16.0), 1e-15);
    EXPECT_NEAR(n(4, {2.0, 0.3, 2, 0.1, 2, 0.4, -2, 0.2, 3, 0.05, -2, 0.03, 4}),
                std::sqrt(2.0 + 0.3 * 0.25 / (l2 - 0.01) + 0.4 * 4.0 / (l2 - 0.008) + 0.05 * 4.0 + 0.03 * 0.0625),
                1e-15);
    EXPECT_NEAR(n(5, {1.5, 0.01, -2, 0.002, -4}), 1.5 + 0.01 * 4.0 + 0.002 * 16.0, 1e-15);
    EXPECT_NEAR(n(6, {0.1, 0.05, 238.0, 0.002, 57.0}), 1.1 + 0.05 / (238.0 - 4.0) + 0.002 / (57.0 - 4.0), 1e-15);
    const double distance = l2 - 0.028;
    EXPECT_NEAR(n(7, {3.4, 0.16, -0.12, 0.01, 0.02, 0.03}),
                3.4 + 0.16 / distance - 0.12 / (distance * distance) + 0.01 * l2 + 0.02 * 0.0625 + 0.03 * 0.015625,
                1e-14);
    const double ratio = 0.4 + 0.1 * l2 / (l2 - 0.07) - 0.002 * l2;
    EXPECT_NEAR(n(8, {0.4, 0.1, 0.07, -0.002}), std::sqrt((1.0 + 2.0 * ratio) / (1.0 - ratio)), 1e-14);
    EXPECT_NEAR(n(9, {2.5, 0.02, 0.03, 0.05, 1.5, 0.9}),
                std::sqrt(2.5 + 0.02 / (l2 - 0.03) + 0.05 * (0.5 - 1.5) / (1.0 + 0.9)), 1e-15);
}

TEST(IndexFormula, AgreesWithAnotherReaderOnPublishedMaterials) {
    const auto csv = reference::read_csv("dispersion_formulas.csv");
    std::vector<int> compared(10, 0);
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        IndexFormula formula{std::stoi(csv.text(row, "formula")), {}};
        std::istringstream words(csv.text(row, "coefficients"));
        for (std::string word; words >> word;) formula.coefficients.push_back(std::strtod(word.c_str(), nullptr));
        EXPECT_LE(formula.coefficients.size(), most_coefficients(formula.number));
        for (const auto& [name, nm] :
             {std::pair{"n_400", 400.0}, {"n_500", 500.0}, {"n_587.6", 587.6}, {"n_700", 700.0}}) {
            const auto expected = csv.number(row, name);
            if (!expected) continue;
            EXPECT_NEAR(formula.at(nm), *expected, 5.1e-8) << csv.text(row, "file") << " at " << nm;  // eight digits
            ++compared[static_cast<std::size_t>(formula.number)];
        }
    }
    for (const std::size_t number : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 9u}) EXPECT_GE(compared[number], 2) << number;
}

TEST(IndexFormula, TakesCoefficientsThatAreLeftOutAsZero) {
    EXPECT_EQ(IndexFormula({5, {1.6}}).at(500.0), 1.6);
    EXPECT_EQ(IndexFormula({6, {}}).at(500.0), 1.0);
    EXPECT_EQ(IndexFormula({7, {3.0}}).at(500.0), 3.0);
    // At 1 um a second resonance of formula 4 whose coefficients are 0 would be 0 / (1 - 0^0).
    EXPECT_EQ(IndexFormula({4, {4.0}}).at(1000.0), 2.0);
    EXPECT_EQ(IndexFormula({4, {4.0, 0, 0, 1, 1}}).at(1000.0), 2.0);
    // The strength of a resonance at wavelength 0 is a constant.
    EXPECT_EQ(IndexFormula({2, {0, 3.0}}).at(500.0), 2.0);
}

TEST(IndexFormula, IsNotFiniteWhereThereIsNoIndex) {
    EXPECT_FALSE(std::isfinite(IndexFormula({1, {0, 1.0, 0.5}}).at(500.0)));  // the resonance itself
    EXPECT_TRUE(std::isnan(IndexFormula({1, {0, 1.0, 0.5}}).at(450.0)));      // n^2 < 0 below it
    EXPECT_FALSE(std::isfinite(IndexFormula({6, {0, 1.0, 4.0}}).at(500.0)));
}

TEST(IndexCurve, IsLinearBetweenTheNodesOfItsTables) {
    IndexCurve curve;
    curve.n = table({400, 500}, {1.5, 1.7});
    curve.k = table({300, 600}, {0.3, 0.0});
    curve.first_nm = 400;
    curve.last_nm = 500;
    EXPECT_EQ(curve.at(400), RefractiveIndex(1.5, 0.3 * 200 / 300));
    EXPECT_NEAR(curve.at(425).real(), 1.55, 1e-15);
    EXPECT_NEAR(curve.at(450).imag(), 0.15, 1e-15);
    EXPECT_EQ(curve.at(500).real(), 1.7);
}

TEST(IndexCurve, HoldsTheValuesOfItsEndsWhereAsked) {
    IndexCurve curve;
    curve.n = IndexFormula{5, {1.5, 0.01, -2}};
    curve.k = table({400, 700}, {0.2, 0.1});
    curve.first_nm = 400;
    curve.last_nm = 700;
    curve.holds_outside = true;
    EXPECT_EQ(curve.at(300), curve.at(400));
    EXPECT_EQ(curve.at(900), curve.at(700));
    EXPECT_EQ(curve.at(900).imag(), 0.1);
    EXPECT_NE(curve.at(650), curve.at(700));
}

TEST(IndexCurve, IsLosslessIfNothingAbsorbs) {
    IndexCurve curve;
    EXPECT_TRUE(curve.is_lossless());
    curve.k = 1e-9;
    EXPECT_FALSE(curve.is_lossless());
    curve.k = table({400, 500, 600}, {0, 0, 0});
    EXPECT_TRUE(curve.is_lossless());
    curve.k = table({400, 500, 600}, {0, 1e-12, 0});
    EXPECT_FALSE(curve.is_lossless());
}

TEST(Index, IsANumberOrAMaterial) {
    const Index glass = 1.5;
    EXPECT_TRUE(glass.is_constant());
    EXPECT_EQ(glass.at(480), RefractiveIndex(1.5, 0.0));
    IndexCurve curve;
    curve.n = malitson_silica;
    const Index silica(std::make_shared<const IndexCurve>(curve));
    EXPECT_FALSE(silica.is_constant());
    EXPECT_EQ(silica.at(500).real(), malitson_silica.at(500));
    EXPECT_NE(silica, Index(std::make_shared<const IndexCurve>(curve)));  // equal, but another object
    EXPECT_EQ(silica, Index(silica));
}

TEST(RefractiveIndex, WhatIsTheSameEverywhereIsNotDispersive) {
    IndexCurve curve;
    EXPECT_FALSE(curve.is_dispersive());
    curve.n = IndexFormula{5, {1.683}};
    EXPECT_FALSE(curve.is_dispersive());
    curve.k = SampledCurve{{400.0, 500.0, 600.0}, {0.06, 0.06, 0.06}};
    EXPECT_FALSE(curve.is_dispersive());
    EXPECT_EQ(curve.at(450.0), RefractiveIndex(1.683, 0.06));
    curve.k = SampledCurve{{400.0, 500.0, 600.0}, {0.06, 0.06, 0.05}};
    EXPECT_TRUE(curve.is_dispersive());
    curve.k = 0.0;
    curve.n = IndexFormula{5, {1.6, 0.01, -2.0}};
    EXPECT_TRUE(curve.is_dispersive());
    EXPECT_FALSE(Index(RefractiveIndex(2.0, 3.0)).is_dispersive());
    EXPECT_TRUE(Index(std::make_shared<const IndexCurve>(curve)).is_dispersive());
}

}  // namespace
}  // namespace nacre
