#pragma once

#include <cstddef>
#include <vector>

#include "nacre/material/mechanism.h"
#include "reference/complex.h"

/// Plane layers as the model sees them: two-ports of amplitudes, composed by summing their bounces (Airy 1833);
/// incoherent ones are two-ports of powers. n + ik, exp(-i omega t). Uneven thicknesses are a trapezium rule over the
/// normal distribution. Graded layers and spreads of more than two layers throw std::runtime_error.
namespace nacre::reference {

struct PlainLayer {
    std::size_t medium = 0;  ///< into PlainLayers::media
    double thickness_nm = 0.0;
    bool is_incoherent = false;
};

/// Groups written out; or the planes of a crystal, whose period is too long to be written out.
struct PlainLayers {
    std::vector<Index> media;  ///< the different ones: incident, substrate, and then the layers'
    std::vector<PlainLayer> layers;
    std::vector<std::size_t> written;  ///< of every layer, its place among those that the stack writes down
    const Crystal* crystal = nullptr;
    double stretch = 1.0;  ///< of a crystal's planes
    const MetalBase* metal = nullptr;
    double share = 1.0;  ///< of the light, if there are several

    bool is_coherent() const;
};

/// Even thicknesses. @param mechanism  a film, stack or crystal, which has to live on
PlainLayers layers_of(const Mechanism& mechanism);

/// As uneven thicknesses make them, with shares whose sum is 1.
std::vector<PlainLayers> thickness_samples_of(const Mechanism& mechanism);

/// What of layers depends on the wavelength alone.
struct MediaAt {
    double nm = 0.0;
    std::vector<Complex> index;   ///< of every medium; of a crystal behind them every slice of a period
    std::vector<Complex> coarse;  ///< of a crystal: the slices of a coarser period
    Complex metal;
};
MediaAt media_at(const PlainLayers& layers, double wavelength_nm);

/// A plane wave where its medium has a real index, which says its direction everywhere: index * sine is the same.
struct Wave {
    double index = 1.0, cosine = 1.0;
    bool is_p = false;
};

/// What layers do to light of one polarisation; a metal base is part of them, any other is not.
struct ModelPowers {
    double reflectance = 0.0, transmittance = 0.0;              ///< of light from above
    double reflectance_below = 0.0, transmittance_below = 0.0;  ///< of light from below, in the substrate
};
ModelPowers powers_at(const PlainLayers& layers, const MediaAt& media, const Wave& wave);
ModelPowers layer_powers(const Mechanism& mechanism, const Wave& wave, double wavelength_nm);

/// The same reflectance of coherent layers, from the substrate up and of nothing else, which is quicker (Rouard 1937).
/// @pre layers.is_coherent()
double coherent_reflectance(const PlainLayers& layers, const MediaAt& media, const Wave& wave);

/// The fraction of the light that enters layers at a wavelength which comes out again from a diffuse base below them,
/// over their transmittance: rho t / (1 - rho r), r and t for light that comes evenly from all directions below.
double base_factor(const Mechanism& mechanism, double wavelength_nm);
double base_factor(const std::vector<PlainLayers>& samples, const Base& base, double wavelength_nm);

// ---- For the files that this is made of ----

/// A medium as a wave sees it.
struct Seen {
    Complex q;           ///< n cos(theta) inside; Im q >= 0
    Complex admittance;  ///< q, or q / n^2
};
Seen seen_in(const Complex& index, const Wave& wave);

/// Amplitudes of light from above and from below.
struct Port {
    Complex r = 0.0, t = 1.0, r_below = 0.0, t_below = 1.0;
};
Port face(const Complex& above, const Complex& below);
Port passage(const Complex& q, double thickness_nm, double wavelength_nm);
/// All bounces between two ports.
Port joined(const Port& above, const Port& below);

/// Indices of slices of a crystal's period.
std::vector<Complex> plane_indices(const Crystal& crystal, int slices, double wavelength_nm);
double spacing_of_planes_nm(const Crystal& crystal);
/// @param indices  of the slices of a period
Port crystal_port(const PlainLayers& layers, double wavelength_nm, const std::vector<Complex>& indices,
                  const Seen& from, const Seen& to, const Wave& wave);

}  // namespace nacre::reference
