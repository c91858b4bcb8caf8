#include "nacre/colour/lobe_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"

namespace nacre {
namespace {

struct Light {
    std::string name;
    TristimulusWeights weights;
    LobeMoments moments;
};

Light light_of(Observer observer, std::string_view illuminant, int first_nm = 360, int last_nm = 830) {
    Light light{std::string(illuminant) + (observer == Observer::cie1931_2deg ? ", 2 degrees" : ", 10 degrees"),
                make_tristimulus_weights(observer, *illuminant_by_name(illuminant), first_nm, last_nm),
                {}};
    light.moments = make_lobe_moments(light.weights);
    return light;
}

/// Fluorescent lamps have lines; the rest is smooth to the eye of a polynomial of degree 6.
bool has_lines(std::string_view illuminant) {
    return illuminant.substr(0, 2) == "FL";
}

std::vector<Light> lights_of(bool with_lines, int first_nm = 360, int last_nm = 830) {
    std::vector<Light> lights;
    for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg}) {
        for (const std::string_view name : illuminant_names()) {
            if (has_lines(name) == with_lines) lights.push_back(light_of(observer, name, first_nm, last_nm));
        }
    }
    return lights;
}

struct Band {
    double peak_nm = 0.0;
    double width_nm = 0.0;
};

/// Evenly over peaks from 300 to 900 nm and over the logarithm of widths from 16 to 1000 nm (Roberts 2018, the plastic
/// number's sequence). Every fourth one ends on a whole nanometre, where a cut cell vanishes.
Band band_of(int i) {
    const auto part = [](double value) { return value - std::floor(value); };
    Band band{300.0 + 600.0 * part(0.5 + i * 0.75487766624669276),
              16.0 * std::pow(1000.0 / 16.0, part(0.5 + i * 0.56984029099805327))};
    if (i % 4 == 0) band.width_nm = std::ceil(band.width_nm);
    if (i % 8 == 0) band.peak_nm = std::floor(band.peak_nm) + 0.5 * std::fmod(band.width_nm, 2.0);
    return band;
}

double distance(const Xyz& one, const Xyz& two) {
    const double largest = std::max({std::abs(one.x - two.x), std::abs(one.y - two.y), std::abs(one.z - two.z)});
    return std::isfinite(one.x + one.y + one.z) ? largest : HUGE_VAL;
}

struct Worst {
    double error = 0.0;
    std::string where = "nowhere";

    void see(double new_error, const Light& light, const Band& band) {
        if (new_error <= error) return;
        error = new_error;
        std::ostringstream text;
        text.precision(17);
        text << "peak " << band.peak_nm << " width " << band.width_nm << ", " << light.name;
        where = text.str();
    }
};

constexpr int bands = 6000;

Worst worst_distance(const std::vector<Light>& lights, double widest_nm) {
    Worst worst;
    for (const Light& light : lights) {
        for (int i = 0; i < bands; ++i) {
            const Band band = band_of(i);
            if (band.width_nm > widest_nm) continue;
            worst.see(distance(lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, band.width_nm, 1.0),
                               lobe_to_xyz(light.weights, band.peak_nm, band.width_nm, 1.0)),
                      light, band);
        }
    }
    return worst;
}

// Under a band that is narrow beside the matching functions these are a polynomial to which the cosine's error is
// orthogonal; a wide one, or one that an end of the range cuts, sees more of the 1.7e-5 by which the cosine errs.
constexpr double narrow_nm = 150.0;
constexpr double any_nm = 1000.0;

TEST(LobeMoments, OfDaylightLampAAndEqualEnergyAgreeWithTheClosedForm) {
    const Worst narrow = worst_distance(lights_of(false), narrow_nm);
    EXPECT_LT(narrow.error, 4e-7) << narrow.where;
    EXPECT_GT(narrow.error, 1e-9) << "the closed form itself";
    const Worst any = worst_distance(lights_of(false), any_nm);
    EXPECT_LT(any.error, 7e-6) << any.where;
    RecordProperty("narrow", std::to_string(narrow.error * 1e9) + "e-9 at " + narrow.where);
    RecordProperty("any", std::to_string(any.error * 1e9) + "e-9 at " + any.where);
}

TEST(LobeMoments, OfFluorescentLampsAgreeWithTheClosedForm) {
    const Worst narrow = worst_distance(lights_of(true), narrow_nm);
    EXPECT_LT(narrow.error, 4e-6) << narrow.where;
    const Worst any = worst_distance(lights_of(true), any_nm);
    EXPECT_LT(any.error, 7e-6) << any.where;
    RecordProperty("narrow", std::to_string(narrow.error * 1e9) + "e-9 at " + narrow.where);
    RecordProperty("any", std::to_string(any.error * 1e9) + "e-9 at " + any.where);
}

TEST(LobeMoments, OfARangeThatEndsInTheLightAgreeToo) {
    EXPECT_LT(worst_distance(lights_of(false, 380, 780), narrow_nm).error, 4e-7);
    EXPECT_LT(worst_distance(lights_of(false, 380, 780), any_nm).error, 7e-6);
    EXPECT_LT(worst_distance(lights_of(true, 380, 780), any_nm).error, 7e-6);
    // A single nanometre sees the cosine's polynomial at one place, and X and Z are below Y there.
    EXPECT_LT(worst_distance(lights_of(false, 520, 521), any_nm).error, 1.8e-5);
}

/// The largest CIEDE2000 by which a band that is the brightest of its LUT changes.
Worst worst_difference(const std::vector<Light>& lights, double widest_nm) {
    Worst worst;
    for (const Light& light : lights) {
        const glm::dmat3 adaptation = adaptation_matrix(Adaptation::bradford, light.weights.white, d65_white);
        for (int i = 0; i < bands; ++i) {
            const Band band = band_of(i);
            const Xyz exact = lobe_to_xyz(light.weights, band.peak_nm, band.width_nm, 1.0);
            if (band.width_nm > widest_nm || exact.y < 0.01) continue;
            const Xyz fast = lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, band.width_nm, 1.0);
            const auto lab = [&](const Xyz& colour) {
                const Xyz seen = adapt(adaptation, colour);
                return to_lab({seen.x / exact.y, seen.y / exact.y, seen.z / exact.y}, d65_white);
            };
            worst.see(ciede2000(lab(exact), lab(fast)), light, band);
        }
    }
    return worst;
}

TEST(LobeMoments, NoEyeTellsTheFastColourFromTheExactOneAtTheBandsOwnBrightness) {
    const Worst smooth = worst_difference(lights_of(false), 470.0);
    EXPECT_LT(smooth.error, 1e-3) << smooth.where;
    // Bands wider than the range itself, of which only a flank is seen: 0.00101 under A.
    const Worst any = worst_difference(lights_of(false), any_nm);
    EXPECT_LT(any.error, 1.2e-3) << any.where;
    const Worst narrow_lines = worst_difference(lights_of(true), narrow_nm);
    EXPECT_LT(narrow_lines.error, 1e-3) << narrow_lines.where;
    // Flanks of wide bands under FL11, nearly all of whose light is in a few lines.
    const Worst any_lines = worst_difference(lights_of(true), any_nm);
    EXPECT_LT(any_lines.error, 3e-3) << any_lines.where;
    RecordProperty("smooth", std::to_string(any.error) + " at " + any.where);
    RecordProperty("lines", std::to_string(any_lines.error) + " at " + any_lines.where);
}

TEST(LobeMoments, NarrowBandsAreTheClosedFormItself) {
    const Light light = light_of(Observer::cie1931_2deg, "FL11");
    for (int i = 0; i < 400; ++i) {
        const Band band = band_of(i);
        for (const double width_nm : {0.0, 1e-9, 0.5, 3.0, 15.0, std::nextafter(narrowest_fast_lobe_nm, 0.0)}) {
            EXPECT_EQ(lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, width_nm, 0.7),
                      lobe_to_xyz(light.weights, band.peak_nm, width_nm, 0.7))
                << band.peak_nm << ' ' << width_nm;
        }
    }
    EXPECT_NE(lobe_to_xyz_fast(light.weights, light.moments, 550.0, narrowest_fast_lobe_nm, 0.7),
              lobe_to_xyz(light.weights, 550.0, narrowest_fast_lobe_nm, 0.7));
}

TEST(LobeMoments, AreProportionalToTheHeight) {
    const Light light = light_of(Observer::cie1964_10deg, "D65");
    for (int i = 0; i < 400; ++i) {
        const Band band = band_of(i);
        const Xyz full = lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, band.width_nm, 1.0);
        const Xyz part = lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, band.width_nm, 0.3);
        // A product more, rounded once.
        EXPECT_NEAR(part.x, 0.3 * full.x, 1e-16);
        EXPECT_NEAR(part.y, 0.3 * full.y, 1e-16);
        EXPECT_NEAR(part.z, 0.3 * full.z, 1e-16);
        EXPECT_EQ(lobe_to_xyz_fast(light.weights, light.moments, band.peak_nm, band.width_nm, 0.0), Xyz{});
    }
}

TEST(LobeMoments, OfBandsBeyondTheRangeAreBlack) {
    const Light light = light_of(Observer::cie1931_2deg, "E", 380, 780);
    for (const double width_nm : {16.0, 33.3, 200.0}) {
        for (const double gap_nm : {0.0, 0.25, 50.0}) {
            EXPECT_EQ(lobe_to_xyz_fast(light.weights, light.moments, 380.0 - 0.5 * width_nm - gap_nm, width_nm, 1.0),
                      Xyz{});
            EXPECT_EQ(lobe_to_xyz_fast(light.weights, light.moments, 780.0 + 0.5 * width_nm + gap_nm, width_nm, 1.0),
                      Xyz{});
        }
        // And a band that just looks in is not: half a nanometre of it.
        EXPECT_GT(lobe_to_xyz_fast(light.weights, light.moments, 380.5 - 0.5 * width_nm, width_nm, 1.0).z, 0.0);
        EXPECT_GT(lobe_to_xyz_fast(light.weights, light.moments, 779.5 + 0.5 * width_nm, width_nm, 1.0).x, 0.0);
    }
}

TEST(LobeMoments, LastOnesAreTheWeightsOwnMoments) {
    // The zeroth moment is white; the first one of E's x, y, z by trapezia of half a nanometre, which are exact for
    // what is linear and err by a twelfth of a step's curvature here: 2e-6 of 1.
    const Light light = light_of(Observer::cie1931_2deg, "E");
    const LobeMoments::Node& last = light.moments.nodes.back();
    EXPECT_NEAR(last.moment[0][0], light.weights.white.x, 1e-13);
    EXPECT_NEAR(last.moment[0][1], 1.0, 1e-13);
    EXPECT_NEAR(last.moment[0][2], light.weights.white.z, 1e-13);
    for (const std::size_t power : {1U, 2U, 6U}) {
        double sum = 0.0;
        for (std::size_t i = 0; i < light.weights.y.size() && i < 471; ++i)
            sum += light.weights.y[i] * std::pow((static_cast<double>(i) - 235.0) / 235.0, static_cast<double>(power));
        EXPECT_NEAR(last.moment[power][1], sum, 1e-5);
    }
}

}  // namespace
}  // namespace nacre
