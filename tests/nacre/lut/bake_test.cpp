#include "nacre/lut/bake.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/colour/illuminant.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

const Palette morpho{{{0, {460, 70, 1}}, {40, {395, 60, 0.7}}}, 0.26};

std::shared_ptr<const Light> light_of(std::optional<int> wavelengths = {}) {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    settings.wavelengths = wavelengths;
    return std::make_shared<const Light>(make_light(settings));
}

Job job_of(std::optional<Axis> y = {}, int width = 64, int height = 1) {
    Job job;
    job.material = {"m", morpho, {}};
    job.light = light_of();
    job.y = std::move(y);
    job.width = width;
    job.height = height;
    return job;
}

TEST(Bake, EndTexelsAreTheEndsOfTheAxis) {
    const Image<Xyz> image = bake(job_of());
    const Job job = job_of();
    const auto at = [&](double theta_deg) {
        return adapt(job.light->adaptation, reflectance_xyz(morpho, Incidence::from_degrees(theta_deg), *job.light));
    };
    EXPECT_EQ(image.at(0, 0), at(90.0)) << "grazing";
    EXPECT_EQ(image.at(63, 0), at(0.0)) << "facing";
}

TEST(Bake, TexelIsTheValueAtItsIndexOverTheLastIndex) {
    const Job job = job_of();
    const Image<Xyz> image = bake(job);
    for (int i = 0; i < 64; ++i) {
        const double cos_theta = std::pow(i / 63.0, 2);
        const Xyz direct =
            adapt(job.light->adaptation, reflectance_xyz(morpho, Incidence::from_cos(cos_theta), *job.light));
        EXPECT_NEAR(image.at(i, 0).z, direct.z, 1e-12);
        EXPECT_EQ(image.at(i, 0), exact_xyz(job, i / 63.0));
    }
}

TEST(Bake, FirstRowIsTheSmallestY) {
    const Job job = job_of(parameter_axis(morpho, "height", 0.0, 1.0), 8, 5);
    const Image<Xyz> image = bake(job);
    EXPECT_EQ(image.at(7, 0), (Xyz{0, 0, 0})) << "height 0 is black";
    EXPECT_GT(image.at(7, 4).z, image.at(7, 3).z);
    EXPECT_NEAR(image.at(7, 2).z, 0.5 * image.at(7, 4).z, 1e-15) << "height scales the lobe";
}

TEST(Bake, ParameterOfOnePickMovesThatPickAlone) {
    Job job = job_of(parameter_axis(morpho, "picks[0].peak_nm", 460.0, 600.0), 8, 8);
    const Image<Xyz> image = bake(job);
    EXPECT_NE(image.at(7, 0), image.at(7, 7)) << "at the normal the first pick is seen";
    job.x = parameter_axis(morpho, "picks[1].peak_nm", 395.0, 500.0);
    job.fixed = Incidence::from_degrees(0.0);
    const Image<Xyz> fixed = bake(job);
    for (int x = 0; x < 8; ++x)
        EXPECT_EQ(fixed.at(x, 0), fixed.at(0, 0)) << "the second pick does not show at the first's angle";
}

TEST(Bake, ARowThatEndsWithoutTiltLeavesNoFacetsToTheNext) {
    Job job = job_of(parameter_axis(morpho, "width_nm", 50.0, 300.0), 5, 3);
    job.x = parameter_axis(morpho, "tilt_deg", 20.0, 0.0);
    job.fixed = Incidence::from_degrees(30.0);
    Job mirrored = job;
    mirrored.x = parameter_axis(morpho, "tilt_deg", 0.0, 20.0);
    const Image<Xyz> image = bake(job), other = bake(mirrored);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) EXPECT_NEAR(image.at(x, y).z, other.at(4 - x, y).z, 1e-12) << x << ", " << y;
    }
}

TEST(Bake, EveryParameterThatIsOfferedSetsSomething) {
    for (const Parameter& parameter : parameters_of(morpho)) {
        Mechanism changed = morpho;
        parameter.set(changed, 0.5);
        EXPECT_NE(changed, Mechanism(morpho)) << parameter.name;
    }
}

TEST(Bake, SampledSpectraApproachTheExactIntegralAsTheirStepShrinks) {
    const Incidence normal = Incidence::from_degrees(0);
    const Xyz exact = reflectance_xyz(morpho, normal, *light_of());
    double last = 1.0;
    for (const int nodes : {48, 95, 471, 4701}) {  // 10, 5, 1 and 0.1 nm
        const Xyz sampled = reflectance_xyz(morpho, normal, *light_of(nodes));
        const double error = std::abs(sampled.z - exact.z) / exact.z;
        EXPECT_LT(error, last) << nodes;
        last = error;
    }
    EXPECT_LT(last, 1e-5);
}

TEST(Bake, SampledWhiteIsWhiteAfterAdaptation) {
    // A lobe so wide that it is 1 all over the range, to within 1 - cos(pi * 235 / 1e9).
    const Palette white{{{0, {595, 1e9, 1}}, {40, {595, 1e9, 1}}}};
    for (const int nodes : {7, 95}) {
        LightSettings settings;
        settings.power = *illuminant_by_name("A");
        settings.wavelengths = nodes;
        const Light light = make_light(settings);
        const Xyz seen = adapt(light.adaptation, reflectance_xyz(white, Incidence::from_degrees(0), light));
        EXPECT_NEAR(seen.x, d65_white.x, 1e-12) << nodes;
        EXPECT_NEAR(seen.y, d65_white.y, 1e-12) << nodes;
        EXPECT_NEAR(seen.z, d65_white.z, 1e-12) << nodes;
    }
}

TEST(Bake, PaperSettingReproducesThePapersWhite) {
    LightSettings settings;
    settings.power = *illuminant_by_name("E");
    settings.adaptation = Adaptation::none;
    settings.first_nm = 380;
    settings.last_nm = 780;
    const Light light = make_light(settings);
    const Xyz white = adapt(light.adaptation, light.white());
    // IEC 61966-2-1, rounded to four digits as the paper's (A.2) has it.
    EXPECT_NEAR(3.2405 * white.x - 1.5371 * white.y - 0.4985 * white.z, 1.205, 1e-3);
    EXPECT_NEAR(-0.9693 * white.x + 1.8760 * white.y + 0.0416 * white.z, 0.948, 1e-3);
    EXPECT_NEAR(0.0556 * white.x - 0.2040 * white.y + 1.0572 * white.z, 0.909, 1e-3);
}

TEST(Response, SAndPAreAlikeAndNothingPassesAPalette) {
    const Response response = response_at(morpho, Incidence::from_degrees(0), 460.0);
    EXPECT_EQ(response.reflectance_s, 1.0);
    EXPECT_EQ(response.reflectance_p, 1.0);
    EXPECT_EQ(response.transmittance_s, 0.0);
}

}  // namespace
}  // namespace nacre
