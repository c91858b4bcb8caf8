#include "nacre/cost/baselines.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "nacre/colour/rgb_space.h"
#include "nacre/shade/palette_colour.h"
#include "reference/csv.h"
#include "reference/number.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

using Observation = std::function<Xyz(double nm)>;

/// The sum that everybody writes: reflectance times light times observer, divided by the same for white.
Xyz plain_sum(const LightSettings& light, const Observation& observer, int step_nm, const Lobe& lobe) {
    Xyz sum;
    Xyz white;
    const auto add = [](Xyz& to, double factor, const Xyz& bars) {
        to = {to.x + factor * bars.x, to.y + factor * bars.y, to.z + factor * bars.z};
    };
    for (int nm = light.first_nm; nm <= light.last_nm; nm += step_nm) {
        const double power = light.power.at(nm);
        add(sum, lobe_reflectance(lobe, nm) * power, observer(nm));
        add(white, power, observer(nm));
    }
    const Xyz relative{sum.x / white.y, sum.y / white.y, sum.z / white.y};
    return adapt(adaptation_matrix(light.adaptation, {white.x / white.y, 1.0, white.z / white.y}, d65_white), relative);
}

Observation table_of(Observer observer) {
    return [observer](double nm) {
        const auto& bars = colour_matching(observer, static_cast<int>(nm));
        return Xyz{bars[0], bars[1], bars[2]};
    };
}

std::vector<LightSettings> many_settings() {
    std::vector<LightSettings> all;
    for (const char* illuminant : {"D65", "A", "FL11"}) {
        LightSettings settings;
        settings.illuminant = illuminant;
        all.push_back(settings);
        settings.observer = Observer::cie1964_10deg;
        settings.adaptation = Adaptation::none;
        settings.first_nm = 381;
        settings.last_nm = 777;
        all.push_back(settings);
    }
    return all;
}

std::vector<Lobe> many_lobes() {
    reference::Uniform uniform(7);
    std::vector<Lobe> lobes;
    for (int i = 0; i < 300; ++i) {
        const double width_nm = std::pow(10.0, uniform.between(-1.0, 3.0));
        lobes.push_back({uniform.between(340.0, 850.0), width_nm, uniform.between(0.0, 1.0)});
        lobes.push_back({std::floor(uniform.between(340.0, 850.0)), 2.0 * std::ceil(width_nm), 1.0});  // ends at nodes
    }
    lobes.push_back({500.0, 0.0, 1.0});
    lobes.push_back({100.0, 50.0, 1.0});
    return lobes;
}

void expect_plain_sum(const Baseline& baseline, const LightSettings& settings, const Observation& observer,
                      int step_nm) {
    double largest = 0.0;
    for (const Lobe& lobe : many_lobes()) {
        const Xyz one = baseline.to_xyz(lobe);
        const Xyz other = plain_sum(settings, observer, step_nm, lobe);
        largest = std::max({largest, std::abs(one.x - other.x), std::abs(one.y - other.y), std::abs(one.z - other.z)});
        ASSERT_TRUE(std::isfinite(one.x + one.y + one.z)) << lobe.peak_nm << ' ' << lobe.width_nm;
    }
    // Up to 471 products of at most 2, each rounded to 1.1e-16, and a recurrence of as many turns.
    EXPECT_LT(largest, 1e-12) << settings.illuminant << ' ' << step_nm;
}

TEST(Baselines, SumsAreThePlainLoopOverEveryStep) {
    for (const LightSettings& settings : many_settings()) {
        const auto light = test::light_of(settings);
        for (const int step_nm : {1, 2, 5, 10, 20})
            expect_plain_sum(*make_sum_baseline(*light, step_nm), light->settings, table_of(settings.observer),
                             step_nm);
    }
}

/// The fit of a name in Wyman, Sloan & Shirley 2013 as wyman2013_cmf_fit.csv prints it.
Observation fit_of_file(const std::string& fit) {
    struct Term {
        std::string function;
        std::function<double(double)> value;
    };
    std::vector<Term> terms;
    const reference::Csv csv = reference::read_csv("wyman2013_cmf_fit.csv");
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        if (csv.text(row, "fit") != fit) continue;
        const auto number = [&](const char* name) { return csv.number(row, name).value_or(0.0); };
        const double amp = number("amp"), mu = number("mu"), low = number("s_lo"), high = number("s_hi");
        const std::string& formula = csv.text(row, "formula");
        std::array<double, 4> c{};
        const auto reads_as = [&](const char* pattern) {
            return std::sscanf(formula.c_str(), pattern, &c[0], &c[1], &c[2], &c[3]) == 4;
        };
        std::function<double(double)> value;
        if (formula == "gauss2") {
            value = [=](double l) { return amp * std::exp(-0.5 * std::pow((l - mu) * (l < mu ? low : high), 2)); };
        } else if (formula == "amp*exp(-0.5*((l-mu)/s)^2)") {
            value = [=](double l) { return amp * std::exp(-0.5 * std::pow((l - mu) / low, 2)); };
        } else if (formula == "amp*exp(-0.5*((ln(l)-ln(mu))/s)^2)") {
            value = [=](double l) { return amp * std::exp(-0.5 * std::pow(std::log(l / mu) / low, 2)); };
        } else if (reads_as("%lf*exp(-%lf*ln((l+%lf)/%lf)^2)")) {
            value = [c](double l) { return c[0] * std::exp(-c[1] * std::pow(std::log((l + c[2]) / c[3]), 2)); };
        } else if (reads_as("%lf*exp(-%lf*ln((l-%lf)/%lf)^2)")) {
            value = [c](double l) { return c[0] * std::exp(-c[1] * std::pow(std::log((l - c[2]) / c[3]), 2)); };
        } else if (reads_as("%lf*exp(-%lf*ln((%lf-l)/%lf)^2)")) {
            value = [c](double l) { return c[0] * std::exp(-c[1] * std::pow(std::log((c[2] - l) / c[3]), 2)); };
        } else {
            throw std::runtime_error("cannot read " + formula);
        }
        terms.push_back({csv.text(row, "function"), value});
    }
    return [terms](double nm) {
        Xyz bars;
        for (const Term& term : terms)
            (term.function == "x" ? bars.x : term.function == "y" ? bars.y : bars.z) += term.value(nm);
        return bars;
    };
}

/// How far a fit is from the CIE's functions, over whole nanometres.
Xyz largest_misfit(const Observation& fit, Observer observer) {
    Xyz largest;
    for (int nm = 360; nm <= 830; ++nm) {
        const Xyz bars = fit(nm);
        const Xyz exact = table_of(observer)(nm);
        largest = {std::max(largest.x, std::abs(bars.x - exact.x)), std::max(largest.y, std::abs(bars.y - exact.y)),
                   std::max(largest.z, std::abs(bars.z - exact.z))};
    }
    return largest;
}

TEST(Baselines, FitsOfTheFileAreTheCiesFunctionsAsNearlyAsWymanSays) {
    // Table 1 and figure 2 of the article: 0.0140, 0.0080 and 0.0222 at most for the fit of many lobes.
    const Xyz multi = largest_misfit(fit_of_file("multi1931"), Observer::cie1931_2deg);
    EXPECT_NEAR(multi.x, 0.0140, 1e-4);
    EXPECT_NEAR(multi.y, 0.0080, 1e-4);
    EXPECT_NEAR(multi.z, 0.0222, 1e-4);
    const Xyz single = largest_misfit(fit_of_file("single1931"), Observer::cie1931_2deg);
    EXPECT_LT(std::max({single.x, single.y, single.z}), 0.17);
    const Xyz single_10deg = largest_misfit(fit_of_file("single1964"), Observer::cie1964_10deg);
    EXPECT_LT(std::max({single_10deg.x, single_10deg.y, single_10deg.z}), 0.07);
}

TEST(Baselines, FitsAreThePlainLoopOverTheArticlesFormulas) {
    for (const LightSettings& settings : many_settings()) {
        const auto light = test::light_of(settings);
        const bool is_2deg = settings.observer == Observer::cie1931_2deg;
        expect_plain_sum(*make_fit_baseline(*light, false), light->settings,
                         fit_of_file(is_2deg ? "multi1931" : "single1964"), 5);
        expect_plain_sum(*make_fit_baseline(*light, true), light->settings,
                         fit_of_file(is_2deg ? "single1931" : "single1964"), 5);
    }
}

TEST(Baselines, WhatReflectsAllIsWhiteToAllOfThem) {
    // A band of a millimetre is 1 - 1.1e-6 at the farthest wavelength from its peak.
    const Lobe white{595.0, 1e6, 1.0};
    for (const char* illuminant : {"D65", "A", "FL2"}) {
        const auto light = test::light_of(illuminant);
        std::vector<std::unique_ptr<Baseline>> baselines;
        for (const int step_nm : {1, 5, 20}) baselines.push_back(make_sum_baseline(*light, step_nm));
        for (const bool single_lobe : {false, true}) baselines.push_back(make_fit_baseline(*light, single_lobe));
        baselines.push_back(make_three_wavelengths_baseline());
        for (std::size_t i = 0; i < baselines.size(); ++i) {
            const Xyz seen = baselines[i]->to_xyz(white);
            EXPECT_NEAR(seen.x, d65_white.x, 2e-6) << illuminant << ' ' << i;
            EXPECT_NEAR(seen.y, 1.0, 2e-6) << illuminant << ' ' << i;
            EXPECT_NEAR(seen.z, d65_white.z, 2e-6) << illuminant << ' ' << i;
        }
    }
}

TEST(Baselines, FinerSumsComeNearerToTheIntegral) {
    const auto light = test::light_of();
    const auto worst_of = [&](const Baseline& baseline) {
        double worst = 0.0;
        for (double peak_nm = 430.0; peak_nm < 660.0; peak_nm += 3.7) {
            const Lobe lobe{peak_nm, 40.0, 1.0};
            const Xyz exact = adapt(light->adaptation, lobe_to_xyz(*light, lobe));
            worst = std::max(worst, std::abs(baseline.to_xyz(lobe).y - exact.y));
        }
        return worst;
    };
    double last = 1.0;
    for (const int step_nm : {20, 10, 5, 2, 1}) {
        const double worst = worst_of(*make_sum_baseline(*light, step_nm));
        // A kinked integrand: the error falls with the square of the step.
        EXPECT_LT(worst, 0.5 * last) << step_nm;
        last = worst;
    }
    EXPECT_LT(last, 1e-4);
}

TEST(Baselines, ABandAtOneOfThreeWavelengthsIsThatPureColour) {
    // Dominant wavelengths of Rec.709's primaries against D65: 611.4, 549.1 and 464.3 nm (sRGB's, as published).
    const glm::dmat3 to_rgb = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
    const auto rgb_of = [&](double peak_nm) {
        return adapt(to_rgb, make_three_wavelengths_baseline()->to_xyz({peak_nm, 30.0, 0.8}));
    };
    // A wavelength in whole nanometres is off by a half at most: the cosine loses 0.0014 to that. Of the others nothing
    // but the rounding of two inverse matrices is seen.
    const Xyz red = rgb_of(611.4), green = rgb_of(549.1), blue = rgb_of(464.3);
    EXPECT_NEAR(red.x, 0.8, 2e-3);
    EXPECT_NEAR(red.y, 0.0, 1e-15);
    EXPECT_NEAR(red.z, 0.0, 1e-15);
    EXPECT_NEAR(green.x, 0.0, 1e-15);
    EXPECT_NEAR(green.y, 0.8, 2e-3);
    EXPECT_NEAR(green.z, 0.0, 1e-15);
    EXPECT_NEAR(blue.x, 0.0, 1e-15);
    EXPECT_NEAR(blue.y, 0.0, 1e-15);
    EXPECT_NEAR(blue.z, 0.8, 2e-3);
    EXPECT_EQ(rgb_of(580.0), (Xyz{0.0, 0.0, 0.0})) << "between them nothing is seen";
}

}  // namespace
}  // namespace nacre
