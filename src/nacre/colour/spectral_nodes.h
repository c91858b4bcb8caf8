#pragma once

#include <map>
#include <memory>
#include <vector>

#include "nacre/base/spectrum.h"
#include "nacre/colour/chebyshev_moments.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// Wavelengths at which a smooth spectrum is sampled, and the weight of each value: X = sum of R(nm) * x.
struct SpectralNodes {
    /// Weights are padded with zeros, and wavelengths with the last one, to a multiple of this: SIMD registers.
    static constexpr int padding = 8;

    int count = 0;                      ///< without the padding
    std::vector<double> wavelength_nm;  ///< count of them
    std::vector<double> x;              ///< padded
    std::vector<double> y;
    std::vector<double> z;
};

/// Product integration: the spectrum is interpolated by a polynomial in the wavenumber 1 / wavelength through Chebyshev
/// nodes, which is integrated exactly against the weights, even if these are not smooth (Sloan & Smith 1978, Math.
/// Comp. 32, 1). Interference fringes are even in wavenumber, so a spectrum with F of them needs little more than pi *
/// F nodes, beyond which the error falls by a factor per node. A spectrum of ones has Y = 1 to rounding.
///
/// More than `most_nodes_of_one_panel` are spread over 4, 8, 16, ... even panels of the wavenumber, up to
/// `most_nodes_per_panel` in each: making them takes as long as there are nodes in a panel.
/// @param count  >= 2
SpectralNodes make_spectral_nodes(const TristimulusWeights& weights, int count);

inline constexpr int most_nodes_of_one_panel = 192;
inline constexpr int most_nodes_per_panel = 64;

/// Makes nodes of many counts for the same weights, and keeps them. What takes longest is the same for all counts that
/// are spread over as many panels.
class NodeMaker {
public:
    /// @param weights  have to outlive it
    explicit NodeMaker(const TristimulusWeights& weights) : weights_(&weights) {}

    /// What make_spectral_nodes() makes. @param count  >= 2
    std::shared_ptr<const SpectralNodes> of(int count);

private:
    const std::vector<ChebyshevMoments>& moments(int panels, int degrees);
    WavenumberPanel panel_of(int i, int panels) const;

    const TristimulusWeights* weights_;
    std::map<int, std::vector<ChebyshevMoments>> moments_;  // by the number of panels, panel by panel
    std::map<int, std::shared_ptr<const SpectralNodes>> nodes_;
};

/// Nodes for a sum over an even grid (trapezium rule).
SpectralNodes make_spectral_nodes(const GridWeights& weights, const WavelengthGrid& grid);

}  // namespace nacre
