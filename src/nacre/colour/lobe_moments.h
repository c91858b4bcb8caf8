#pragma once

#include <array>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// The tables of lobe_to_xyz_fast(): running integrals of the weights times powers of the wavelength.
///
/// Built in about 20 microseconds; 120 kB for the whole visible range.
struct LobeMoments {
    static constexpr int powers = 7;

    /// One whole nanometre. Rows of four, (X, Y, Z, 0), so that a row is a register.
    struct Node {
        std::array<double, 4> moment[powers];  ///< integral from first_nm to here of weight(nm) * t(nm)^power
        std::array<double, 4> weight;          ///< weight(nm)
    };

    int first_nm = 0;
    int last_nm = 0;
    double centre_nm = 0.0;  ///< t = (nm - centre_nm) / half_range_nm runs from -1 to 1
    double half_range_nm = 1.0;
    double per_half_range = 1.0;  ///< 1 / half_range_nm
    std::vector<Node> nodes;      ///< last_nm - first_nm + 1
};

LobeMoments make_lobe_moments(const TristimulusWeights& weights);

/// lobe_to_xyz() in a time that does not depend on the width: seven running integrals at either end of the lobe.
///
/// Under the whole cells the cosine is the polynomial of degree 6 that is nearest to it in the mean, so the error is
/// orthogonal to all smooth weights; the two cut cells have their sine's first two terms. Lobes narrower than
/// `narrowest_fast_lobe_nm` are handed to lobe_to_xyz().
/// Accuracy: 6e-6 of X, Y and Z (white is about 1); 4e-7 up to 150 nm of width under lights without lines. That is
/// CIEDE2000 0.001 at the lobe's own brightness, except for lobes of which only a flank lies in the range or under a
/// line of a lamp (0.003); see tests/nacre/colour/lobe_moments_test.cpp.
/// @param weights,moments  the second made of the first
Xyz lobe_to_xyz_fast(const TristimulusWeights& weights, const LobeMoments& moments, double peak_nm, double width_nm,
                     double height);

inline constexpr double narrowest_fast_lobe_nm = 16.0;

}  // namespace nacre
