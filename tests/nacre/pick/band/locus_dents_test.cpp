// Next to the spectral locus of the 1 nm tables some reflectances with more than two jumps are brighter than every
// band. A search through the bands of floor 0 says how near one can come to such a colour.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "nacre/pick/band/picked_bands.h"
#include "reference/optimal_colour.h"

namespace nacre::test {
namespace {

using reference::ModelRgb;
using reference::ModelXyz;

// The band of one flatness and width that comes nearest: of the luminance, or as bright as it can be.
double least_difference(const PickLight& light, const Xyz& colour, double flatness, double width_nm) {
    const double luminance = light.model.seen_as(as_model(colour))[1];
    const auto difference = [&](double peak_nm) {
        const double unit = light.integral(peak_nm, width_nm, flatness)[1];
        return light.difference({peak_nm, width_nm, std::min(luminance / unit, 1.0), 0.0, flatness}, colour);
    };
    double nearest_nm = 0.0, least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](double peak_nm) {
        const double here = difference(peak_nm);
        if (!(here < least)) return false;
        least = here;
        nearest_nm = peak_nm;
        return true;
    };
    for (double peak_nm = 580.0; peak_nm <= 650.0; peak_nm += 2.0) look_at(peak_nm);
    for (double step_nm = 1.0; step_nm > 1e-5;) {
        const double centre_nm = nearest_nm;
        const bool is_nearer = look_at(centre_nm - step_nm) || look_at(centre_nm + step_nm);
        if (!is_nearer) step_nm *= 0.5;
    }
    return least;
}

double least_difference(const PickLight& light, const Xyz& colour) {
    double least = std::numeric_limits<double>::infinity();
    for (const double flatness : {0.0, 0.3, 0.6, 0.9, 0.999}) {
        for (double width_nm = 2.0; width_nm < 150.0; width_nm *= 1.03)
            least = std::min(least, least_difference(light, colour, flatness, width_nm));
    }
    return least;
}

struct InADent {
    ModelRgb encoded;  // P3 or ACEScg, gamma 2.4
    ModelXyz (*to_xyz)(const ModelRgb& linear);
};

// The worst of 60000 random colours of each space under illuminant A; no other of them differs by more than 0.01.
TEST(LocusDents, AreMetNearlyAsWellAsABandCan) {
    const PickLight light("A");
    const reference::OptimalColours optimal(light.model);
    Xyz worst;
    double worst_difference = 0.0;
    for (const InADent& pick : {InADent{{0.968003, 0.374938, 0.057519}, reference::from_p3d65},
                                InADent{{0.978680, 0.526669, 0.141085}, reference::from_acescg},
                                InADent{{0.744644, 0.377330, 0.115453}, reference::from_acescg}}) {
        ModelRgb linear = pick.encoded;
        for (double& component : linear) component = std::pow(component, 2.4);
        const ModelXyz picked = pick.to_xyz(linear);
        const ShownColour shown = shown_colour(light.bands, light.core, as_xyz(picked));
        EXPECT_NEAR(shown.luminance, optimal.brightest_share(light.model.seen_as(picked)), 1e-4);
        const Lobe band = light.only_band(shown.colour);
        worst_difference = light.difference(band, shown.colour);
        EXPECT_LE(worst_difference, 0.0135) << text_of(band);
        worst = shown.colour;
    }
    const double least = least_difference(light, worst);
    EXPECT_GT(least, 0.01) << "a band can have the last colour";
    EXPECT_LE(worst_difference, least + 0.003);
}

}  // namespace
}  // namespace nacre::test
