#pragma once

#include <vector>

#include "reference/complex.h"

namespace nacre::reference {

/// |S1|^2, |S2|^2 and cross-sections over pi r^2 of a sphere, in double (Bohren & Huffman 1983, chapter 4 and appendix
/// A): for size parameters from 0.05 to 50.
struct ModelSphere {
    double q_sca = 0.0, q_ext = 0.0;
    std::vector<Complex> a, b;  ///< [n]; [0] is not used

    struct Amplitudes {
        Complex s1, s2;
    };
    Amplitudes amplitudes(double cos_scatter) const;
};
ModelSphere model_sphere(double size_parameter, Complex relative_index);

}  // namespace nacre::reference
