#pragma once

#include <cstddef>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// Cosine and sine of one phase.
struct Phasor {
    double cosine = 1.0;
    double sine = 0.0;
};

/// Angles for which small_phasor() keeps its accuracy: slightly more than pi / 8.
inline constexpr double small_angle = 0.4;

/// Cosine and sine of x by their Taylor series, without a call.
/// Accuracy: the first dropped terms are below 1e-19 and 1e-19 for 0 <= x <= small_angle.
inline Phasor small_phasor(double x) {
    const double q = x * x;
    return {1.0 - q * (1.0 / 2.0 -
                       q * (1.0 / 24.0 -
                            q * (1.0 / 720.0 - q * (1.0 / 40320.0 - q * (1.0 / 3628800.0 - q * (1.0 / 479001600.0)))))),
            x * (1.0 - q * (1.0 / 6.0 -
                            q * (1.0 / 120.0 - q * (1.0 / 5040.0 - q * (1.0 / 362880.0 - q * (1.0 / 39916800.0))))))};
}

/// Sum of weight[i] * cos(first + i * step), i in [0, count), for three weights at once: SIMD (Highway).
/// @param x,y,z  may be read up to TristimulusWeights::padding numbers past their end
Xyz weighted_cosines(const double* x, const double* y, const double* z, std::size_t count, Phasor first, Phasor step);

/// A run of whole cells under a cosine of phase per_nm * (nm - peak). Here `nm` counts cells of the weights.
struct WholeCells {
    int first_nm = 0;  ///< weights.first_cell() <= first_nm < last_nm <= weights.last_cell()
    int last_nm = 0;
    double per_nm = 0.0;  ///< in (0, pi / 4]
    Phasor first_phase;   ///< of the phase at first_nm
    Phasor last_phase;    ///< of the phase at last_nm
};

/// Integral over the cells of the cosine times the piecewise linear weights, exactly.
///
/// SIMD (Highway) with the widest instruction set of the machine; the last bits may differ between instruction sets.
/// Accuracy: 5e-14 absolute; tests compare it with the per-cell form.
Xyz integrate_whole_cells(const TristimulusWeights& weights, const WholeCells& cells);

}  // namespace nacre
