#pragma once

#include <vector>

#include "nacre/base/sampled_curve.h"
#include "nacre/base/spectrum.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/observer.h"

namespace nacre {

/// Observer x illuminant at the borders of cells, linear between them, normalised so that R = 1 has Y = 1.
///
/// A cell is one nanometre, or less for lamps with finer lines. `x`, `y`, `z` hold one weight per border of a cell from
/// first_nm to last_nm; with p = nm * cells_per_nm, a curve R has X = integral of R(nm) * x(p) d p, where x(p) is the
/// piecewise linear function through the weights.
/// Everything below integrates that function, and normalises by the same rule, so white is exact.
struct TristimulusWeights {
    /// Zeros behind the last weight, so that a SIMD register may be loaded past it.
    static constexpr int padding = 32;

    int first_nm = 0;
    int last_nm = 0;
    int cells_per_nm = 1;  ///< a power of two, so that borders of cells are exact
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    std::vector<Xyz> cumulative;  ///< the integral from first_nm to every border of a cell
    Xyz white;                    ///< what R = 1 over the whole range integrates to; white.y == 1

    /// Number of weights, the padding not counted.
    int count() const { return (last_nm - first_nm) * cells_per_nm + 1; }
    /// Where the weights begin and end, in cells.
    int first_cell() const { return first_nm * cells_per_nm; }
    int last_cell() const { return last_nm * cells_per_nm; }
};

/// A lamp with nodes closer than one nanometre is integrated on its own nodes (see lamp_weights.h).
/// @param illuminant          relative spectral power, any scale, linear between its nodes, 0 outside them
/// @param first_nm,last_nm    range of integration, 360 <= first_nm < last_nm <= 830
/// @pre the illuminant has power somewhere in the range (planning guarantees it)
TristimulusWeights make_tristimulus_weights(Observer observer, const SampledCurve& illuminant, int first_nm = 360,
                                            int last_nm = 830);

/// A reflectance band of height 1: 1 on a plateau of `flatness` times its width, and half cosines down to 0 beside it.
struct BandShape {
    double peak_nm = 0.0;   ///< any finite number
    double width_nm = 0.0;  ///< from zero to zero, >= 0; 0 is black
    double flatness = 0.0;  ///< in [0, 1); 0 is one half cosine

    double plateau_nm() const { return flatness * width_nm; }
};

/// Tristimulus values of a band, exactly.
///
/// Product integration: over one cell the weight is linear and a shoulder a cosine, which has a closed form; a
/// plateau takes two running integrals (see tristimulus.cpp). There is no sampling error at any width and flatness;
/// rounding errors are up to 3e-14 absolute (observed).
Xyz band_to_xyz(const TristimulusWeights& weights, const BandShape& band);

/// The same by the closed form of every cell, one by one: the scalar reference implementation that tests and benchmarks
/// compare band_to_xyz() with.
Xyz band_to_xyz_per_cell(const TristimulusWeights& weights, const BandShape& band);

/// Integral of the weights over a range of wavelengths, cut off where they end.
Xyz plateau_to_xyz(const TristimulusWeights& weights, double from_nm, double to_nm);

/// Weights for spectra sampled at a grid: X = sum of value[i] * x[i] (trapezium rule at the grid's nodes,
/// weights linear between borders of cells), normalised so that a spectrum of ones has Y = 1.
struct GridWeights {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    Xyz white;  ///< of a spectrum of ones; white.y is 1 up to rounding
};

/// @pre grid lies within [weights.first_nm, weights.last_nm], and some node of it has light
GridWeights make_grid_weights(const TristimulusWeights& weights, const WavelengthGrid& grid);

/// @pre spectrum has as many values as the weights
Xyz to_xyz(const GridWeights& weights, const Spectrum& spectrum);

}  // namespace nacre
