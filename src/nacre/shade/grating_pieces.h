#pragma once

#include <array>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// A light's range in pieces over which a grating's profile and the light's weights are parabolas in 1 / wavelength.
struct GratingPieces {
    int nm = 1;                               ///< that a piece spans, unless the profile wants shorter ones
    std::vector<double> per_nm;               ///< of points, ascending in wavelength; pieces are points 2 i to 2 i + 2
    std::vector<std::array<Xyz, 3>> weights;  ///< per piece, at its points: times wavelength
};

/// The error limit of coarse pieces for the phases of a profile: 3e-3 of half the efficiency. Beyond, they are cut.
inline constexpr double most_coarse_phase_change = 0.7;

/// How far the phases of a profile so deep move over a nanometre, at most. @param first_nm  of the light
double profile_phase_per_nm(double depth_nm, double first_nm);

/// Pieces of 1 nm are parabolas to 1.4e-6 of half the efficiency; coarser ones to 3e-3 of it.
/// @param nm        >= 1
/// @param depth_nm  of the profile
GratingPieces grating_pieces(const TristimulusWeights& weights, int nm, double depth_nm);

}  // namespace nacre
