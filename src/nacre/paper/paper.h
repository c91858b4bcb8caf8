#pragma once

#include <string>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/palette.h"

namespace nacre {

// Data of Park & Tsuruno 2014, "A Color Palette based Interface for Biological Iridescences Rendering",
// J. ADADA 18(1): its two specimens, and the exact optics that its approximations replace.

/// Layers that reflect, as the Bragg law needs them: solid ones and the air between.
struct BraggStack {
    double solid_index = 1.0;  ///< n >= 1, real
    double solid_nm = 0.0;     ///< thickness per period
    double air_nm = 0.0;       ///< likewise; 0: the layers touch
};

/// One of the two animals of section 5.1.
struct Specimen {
    std::string name;   ///< as in file names and configs/scenes: "morpho"
    std::string title;  ///< for people: "Morpho butterfly", "Jewel beetle"
    Palette palette;
    BraggStack stack;                ///< what the two picks imply
    std::vector<double> angles_deg;  ///< of Figure 14
};

Specimen paper_morpho();
Specimen paper_beetle();

/// 0, 1, ..., 90 degrees: enough for smooth curves, and the errors' maxima are flat.
std::vector<Incidence> whole_degrees();

/// n * cos(angle in the solid) = sqrt(n^2 - sin^2(theta)): the paper's X_A, one solid layer's path per thickness.
double path_factor(double index, const Incidence& incidence);

/// Straight line in cos^2(theta) through the ends of path_factor(): (3.2.4), normalised there to the same ends.
///
/// Never above it. The line that errs least overall lies half the largest error higher.
double path_factor_line(double index, const Incidence& incidence);

/// First-order Bragg wavelength 2 (d_solid sqrt(n^2 - sin^2) + d_air cos), in nm: (3.2.1) in vacuum wavelengths.
double bragg_peak_nm(const BraggStack& stack, const Incidence& incidence);

}  // namespace nacre
