#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/accuracy/probes.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// The wavelengths at which spectra are sampled, and what that errs by.
struct ChosenNodes {
    std::array<std::shared_ptr<const SpectralNodes>, band_least_cos_theta.size()> nodes;
    std::vector<std::size_t> incoherent_layers;  ///< whose fringes nobody sees; nodes of the layer system
    double error = 0.0;                          ///< CIEDE2000, the largest of all bands
};

/// How many tolerances a band may err by. In a film that stands free, light at grazing runs to and fro so often that no
/// grid resolves its fringes: there an error falls only as they are hit by more nodes. The last band is one hundredth
/// of the default axis.
inline constexpr std::array<double, band_least_cos_theta.size()> tolerances_of_band{1.0, 1.0, 2.0, 3.0};

/// The fewest nodes that keep colours within the tolerance at the probes of each band.
///
/// @param sampling   the slices and radii are chosen
/// @param tolerance  CIEDE2000 at the scale of the brightest probe; twice and three times that in the two bands next to
///                   grazing
/// @param requested  what the scene requests, compared with the nodes that would do; 0: nothing
/// @param fewest     per band; a search does not begin below
/// @pre samples_spectra() of the job's mechanism
ChosenNodes choose_nodes(const Probes& probes, SpectralSampling sampling, double tolerance, const NodeCounts& requested,
                         const NodeCounts& fewest, ProbeTally& tally);

/// The share of an error in a band that is seen. What of a surface's facets is seen within so small a cosine goes with
/// its square: of facets that lean every way, those that are seen at grazing hardly count. 1 without facets.
double seen_share_of_band(const Probes& probes, std::size_t band);

/// Samples of uneven thicknesses while other numbers are chosen: their mean is about as smooth as that of all
/// (empirical).
inline constexpr int few_thickness_samples = 8;

}  // namespace nacre
