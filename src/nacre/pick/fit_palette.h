#pragma once

#include <cstddef>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/light.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/optics/palette.h"

namespace nacre {

/// How a palette compares with a measurement at one of its angles.
struct AngleFit {
    double angle_deg = 0.0;
    double measured_peak_nm = 0.0;  ///< where the spectrum is highest, among visible wavelengths
    double peak_nm = 0.0;           ///< the palette's
    double de00 = 0.0;              ///< CIEDE2000 of the two colours
};

struct PaletteFit {
    Palette palette;
    std::vector<AngleFit> angles;  ///< all that were measured
    double error = 0.0;            ///< root mean square of their CIEDE2000
};

/// The palette with a given number of picks whose colours are nearest to those of measured spectra, at all their angles
/// together.
///
/// Picks stand at measured angles, evenly spread in Y(theta) between the first and the last. Their bands begin with
/// the peaks and areas of the spectra there; then bands and shape move together, by least squares of CIEDE2000's parts,
/// and of the peak where the spectrum has one (10 nm count as much as a CIEDE2000 of 1), so that the band stays near
/// the measured peak. With as many picks as angles the shape is the default.
/// @param picks  2 or more, at most as many as angles (1, if only one angle was measured)
PaletteFit fit_palette(const MeasuredSpectra& spectra, std::size_t picks, const Light& light,
                       const LeastSquaresSolver& solve);

/// Where a measured spectrum is highest between 380 and 780 nm: the vertex of the parabola through its highest sample
/// and the two beside it.
double measured_peak_nm(const MeasuredSpectra& spectra, std::size_t angle);

}  // namespace nacre
