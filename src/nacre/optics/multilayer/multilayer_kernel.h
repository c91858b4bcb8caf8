#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "nacre/optics/layer_system.h"
#include "nacre/optics/polarisation.h"
#include "nacre/optics/response.h"
#include "nacre/optics/transverse.h"

namespace nacre {

// What MultilayerSolver prepares for its kernel, and what the kernel answers.

/// A layer or a group, its members side by side: they are steps [first, last).
struct LayerStep {
    double thickness_nm = 0.0;
    int medium = 0;
    int repeat = 0;  ///< 0: a layer
    int first = 0;
    int last = 0;
    bool is_short = false;  ///< of a group: a few layers and nothing else
    int growth = 0;         ///< of a layer: parts of fields grow by a factor of at most 2^growth
};

/// Layers that interfere, between two media.
struct CoherentPart {
    int above = 0;  ///< medium
    int below = 0;
    int first = 0;  ///< steps [first, last), in the order in which light from above meets them
    int last = 0;
};

/// A LayerSystem at fixed wavelengths.
struct PreparedLayers {
    static constexpr std::size_t padding = 8;  ///< a multiple of every machine's lanes of double

    std::size_t wavelengths = 0;               ///< padded
    std::vector<double> quarter_turns_per_nm;  ///< of phase, in vacuum: 4 / wavelength
    std::vector<double> n;                     ///< curves x wavelengths
    std::vector<double> k;
    std::vector<Medium> media;
    std::vector<char> is_lossless;    ///< per medium
    std::vector<char> is_dispersive;  ///< per medium: whether anything about it depends on the wavelength
    std::vector<double> least_n;      ///< per medium: the smallest n at any wavelength
    double largest_n0 = 0.0;          ///< of the incident medium
    int incident = 0;
    int substrate = 0;
    std::vector<LayerStep> steps;
    std::vector<CoherentPart> parts;    ///< from the top down
    std::vector<LayerStep> incoherent;  ///< between the parts: one fewer
};

/// The same at one angle.
struct LayersAtAngle {
    const PreparedLayers* layers;
    Transverse transverse;
    std::vector<char> is_plain;       ///< per medium: lossless, and no evanescent wave at any wavelength
    std::vector<char> is_plain_step;  ///< per step: the same, of a group all its members
};

/// @param out  padded
void multilayer_responses(const LayersAtAngle& angle, Response* out);
std::array<double, 3> multilayer_weighted(const LayersAtAngle& angle, const std::array<const double*, 3>& weights,
                                          Observed observed, Polarisation polarisation);

}  // namespace nacre
