#include "nacre/paper/paper.h"

#include <cmath>

#include "nacre/optics/incidence.h"

namespace nacre {

Specimen paper_morpho() {
    // Picks: section 5.1. Cuticle n = 1.56: Vukusic et al. 1999, Proc. R. Soc. B 266, 1403. The thicknesses solve
    // bragg_peak_nm() = 460 and 395 nm at 0 and 40 degrees, to 0.1 nm. p follows that stack best (Figure 8).
    return {"morpho",
            "Morpho butterfly",
            {{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}, 0.26},
            {1.56, 94.1, 83.2},
            {0.0, 10.0, 20.0, 30.0, 40.0}};
}

Specimen paper_beetle() {
    // Picks: section 5.1, after Stavenga et al. 2011, Phil. Trans. R. Soc. B 366, 709. The two peaks imply one index,
    // 1.717, and 532.7 nm at the normal: n^2 = (sin^2 60 - r sin^2 10) / (1 - r) with r = (460 / 530)^2.
    constexpr double index = 1.717;
    constexpr double normal_peak_nm = 532.7;
    return {"beetle",
            "Jewel beetle",
            {{{10.0, {530.0, 110.0, 0.73}}, {60.0, {460.0, 110.0, 1.0}}}, 0.91},
            {index, normal_peak_nm / (2.0 * index), 0.0},
            {20.0, 30.0, 40.0, 50.0, 60.0}};
}

std::vector<Incidence> whole_degrees() {
    std::vector<Incidence> angles;
    for (int degrees = 0; degrees <= 90; ++degrees) angles.push_back(Incidence::from_degrees(degrees));
    return angles;
}

double path_factor(double index, const Incidence& incidence) {
    // n^2 - 1 + cos^2 rather than n^2 - sin^2: exact at grazing, where the cosine is the small number.
    return std::sqrt((index - 1.0) * (index + 1.0) + incidence.cos_theta * incidence.cos_theta);
}

double path_factor_line(double index, const Incidence& incidence) {
    const double grazing = path_factor(index, Incidence::from_cos(0.0));
    return std::lerp(grazing, index, incidence.cos_theta * incidence.cos_theta);
}

double bragg_peak_nm(const BraggStack& stack, const Incidence& incidence) {
    return 2.0 * (stack.solid_nm * path_factor(stack.solid_index, incidence) + stack.air_nm * incidence.cos_theta);
}

}  // namespace nacre
