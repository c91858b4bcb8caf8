#include "nacre/accuracy/reference.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nacre/scene/readers/axis_reader.h"
#include "reference/lobe_quadrature.h"
#include "reference/weights.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

Palette same_at_every_angle(const Lobe& lobe) {
    return {{{0.0, lobe}}};
}

void expect_near(const Xyz& one, const Xyz& other, double tolerance, const Lobe& lobe, const std::string& light) {
    const auto where = [&] {
        return light + ", peak " + std::to_string(lobe.peak_nm) + ", width " + std::to_string(lobe.width_nm);
    };
    EXPECT_NEAR(one.x, other.x, tolerance) << where();
    EXPECT_NEAR(one.y, other.y, tolerance) << where();
    EXPECT_NEAR(one.z, other.z, tolerance) << where();
}

/// Every kind of light that a scene can ask for.
std::vector<LightSettings> many_settings() {
    std::vector<LightSettings> all;
    for (const char* illuminant : {"D65", "A", "FL11"}) {
        LightSettings settings;
        settings.illuminant = illuminant;
        all.push_back(settings);
        settings.observer = Observer::cie1964_10deg;
        settings.adaptation = Adaptation::cat16;
        settings.first_nm = 380;
        settings.last_nm = 780;
        all.push_back(settings);
        settings.adaptation = Adaptation::none;
        all.push_back(settings);
    }
    return all;
}

void expect_the_closed_form(const std::vector<double>& widths_nm, double tolerance) {
    reference::Uniform uniform(5);
    for (const LightSettings& settings : many_settings()) {
        const auto light = test::light_of(settings);
        for (const double width_nm : widths_nm) {
            for (int i = 0; i < 6; ++i) {
                // Some on whole nanometres, some cut by an end of the range, some beyond it.
                const double any_nm = uniform.between(350.0 - 0.5 * width_nm, 840.0 + 0.5 * width_nm);
                const Lobe lobe{i == 0 ? std::floor(any_nm) : any_nm, width_nm, 0.8};
                Job job = test::job_of(same_at_every_angle(lobe));
                job.light = light;
                expect_near(Reference(job).at(0.3), exact_xyz(job, 0.3), tolerance, lobe, settings.illuminant);
            }
        }
    }
}

TEST(Reference, OfBandsOf4NanometresAndMoreIsTheClosedFormTo1em9) {
    expect_the_closed_form({4.0, 4.7, 8.0, 30.0, 70.0, 333.3, 940.0, 5000.0}, 1e-9);
}

TEST(Reference, OfNarrowerBandsIsTheClosedFormTo1em7) {
    expect_the_closed_form({1e-3, 0.3, 1.0, 1.7, 2.0, 3.999}, 1e-7);
}

TEST(Reference, AgreesWithQuadratureIn50Digits) {
    LightSettings settings;
    settings.illuminant = "FL11";
    settings.adaptation = Adaptation::none;
    const auto light = test::light_of(settings);
    const reference::Weights weights = reference::weights_from_files("cmf_cie1931_2deg_1nm.csv", "FL11", 360, 830);
    for (const Lobe& lobe : {Lobe{460.25, 41.5, 0.9}, Lobe{611.0, 2.5, 0.7}}) {
        Job job = test::job_of(same_at_every_angle(lobe));
        job.light = light;
        const Xyz colour = Reference(job).at(1.0);
        const reference::XyzNumbers exact =
            reference::reference_lobe_to_xyz(weights, lobe.peak_nm, lobe.width_nm, lobe.height);
        const double tolerance = lobe.width_nm >= 4.0 ? 1e-9 : 1e-7;
        EXPECT_LT(reference::distance(colour.x, exact.x), tolerance);
        EXPECT_LT(reference::distance(colour.y, exact.y), tolerance);
        EXPECT_LT(reference::distance(colour.z, exact.z), tolerance);
        EXPECT_GT(colour.y, 1e-3);
    }
}

TEST(Reference, FollowsTheMaterialOverBothAxes) {
    const std::vector<Job> jobs{
        test::job_of(test::morpho),
        test::job_of(test::opal, parameter_axis(test::opal, "shape", 0.0, 1.0), 8, 8),
        test::job_of(test::beetle, parameter_axis(test::beetle, "picks[0].width_nm", 5.0, 200.0), 8, 8),
        test::job_over(test::morpho, parameter_axis(test::morpho, "peak_nm", 400.0, 700.0), 25.0),
    };
    reference::Uniform uniform(6);
    for (const Job& job : jobs) {
        const Reference reference(job);
        for (int i = 0; i < 50; ++i) {
            const double x = uniform.between(0.0, 1.0);
            const double y = uniform.between(0.0, 1.0);
            expect_near(reference.at(x, y), exact_xyz(job, x, y), 1e-9, {}, job.x.parameter.name);
        }
        expect_near(reference.at(1.0, 1.0), exact_xyz(job, 1.0, 1.0), 1e-9, {}, "the last corner");
    }
}

TEST(Reference, KnowsNoNodes) {
    Job sampled = test::job_of(test::morpho);
    sampled.light = test::light_of("D65", 12);
    const Job exact = test::job_of(test::morpho);
    for (const double x : {0.85, 0.95, 1.0}) {
        EXPECT_EQ(Reference(sampled).at(x), Reference(exact).at(x));
        EXPECT_GT(std::abs(exact_xyz(sampled, x).z - exact_xyz(exact, x).z), 1e-3) << "as if 12 nodes were enough";
    }
}

TEST(Reference, OfABandWithoutWidthOrHeightOrLightIsBlack) {
    for (const Lobe& lobe :
         {Lobe{500.0, 0.0, 1.0}, Lobe{500.0, 70.0, 0.0}, Lobe{200.0, 300.0, 1.0}, Lobe{900.0, 140.0, 1.0}}) {
        const Job job = test::job_of(same_at_every_angle(lobe));
        EXPECT_EQ(Reference(job).at(0.5), Xyz{}) << lobe.peak_nm;
    }
}

}  // namespace
}  // namespace nacre
