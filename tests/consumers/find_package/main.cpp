// Bakes one colour with the installed core and compares it with a plain sum; exits with 1 if they differ.
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/optics/palette.h"

int main() {
    const nacre::Palette morpho{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}};
    const auto weights =
        nacre::make_tristimulus_weights(nacre::Observer::cie1931_2deg, *nacre::illuminant_by_name("D65"));

    const nacre::Lobe lobe = nacre::palette_lobe(morpho, nacre::Incidence::from_degrees(20.0));
    const nacre::Xyz unit = nacre::band_to_xyz(weights, {lobe.peak_nm, lobe.width_nm});
    const nacre::Xyz colour{lobe.height * unit.x, lobe.height * unit.y, lobe.height * unit.z};

    nacre::Xyz sum;
    for (int i = 0; i < weights.count(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const double reflectance = nacre::lobe_reflectance(lobe, weights.first_nm + i);
        sum.x += reflectance * weights.x[index];
        sum.y += reflectance * weights.y[index];
        sum.z += reflectance * weights.z[index];
    }

    std::printf("XYZ %.6f %.6f %.6f\n", colour.x, colour.y, colour.z);
    // A 1 nm sum of a lobe more than 60 nm wide is right to three digits.
    const auto close = [](double a, double b) { return b > 0.0 && std::abs(a - b) < 1e-3 * b; };
    return close(colour.x, sum.x) && close(colour.y, sum.y) && close(colour.z, sum.z) ? 0 : 1;
}
