#pragma once

namespace nacre {

/// Where a LUT's error comes from; CIEDE2000 each, the largest over the LUT.
struct ErrorSplit {
    double total = 0.0;          ///< not the sum: the worst points of the parts need not coincide
    double spectrum = 0.0;       ///< of how spectra become XYZ
    double spread = 0.0;         ///< of the number of samples of uneven thicknesses
    double quadrature = 0.0;     ///< of a base's directions, of radii, of slices
    double effects = 0.0;        ///< of effects that are left out
    double interpolation = 0.0;  ///< of the linear filter between exact texels
    double storage = 0.0;        ///< of the number format, at the texels
};

}  // namespace nacre
