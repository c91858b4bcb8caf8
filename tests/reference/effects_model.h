#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "nacre/material/mechanism.h"
#include "reference/dense_model.h"

namespace nacre::reference {

/// The colour of any mechanism with any of its effects, by the textbook and by brute force. It reads the plain structs
/// that say what a material is, and calls nothing of src/.
///
/// Layers are two-ports of amplitudes, composed by summing their bounces (Airy 1833); incoherent ones are two-ports of
/// powers. Uneven thicknesses are a trapezium rule over the normal distribution. A base's directions are a midpoint
/// rule per wavelength, crowded where total reflection begins. Facets are integrated around the eye, not around the
/// surface's normal. A grating's lines are midpoints, ten per ripple. Spheres have Bohren and Huffman's recurrences,
/// their radii a trapezium rule over the logarithm, their order Percus and Yevick's direct correlation. Measured
/// spectra are cubics in Hermite's form.
///
/// What it does not know: graded layers, spreads of more than two layers: then it throws std::runtime_error. Spreads of
/// layers that are mirrors on both sides, as free films are at grazing, are too much for it.
class EffectsModel {
public:
    /// Light from 360 to 830 nm, Bradford to D65. @param illuminant  a column of illuminants_5nm.csv
    /// @param tolerance  CIEDE2000 by which twice as many wavelengths may still change a colour, at the scale of the
    /// brightest asked for
    EffectsModel(const Mechanism& mechanism, const std::string& illuminant, int observer_deg, double tolerance);
    ~EffectsModel();
    EffectsModel(EffectsModel&&) noexcept;
    EffectsModel& operator=(EffectsModel&&) noexcept;

    /// Relative to D65, Y = 1 for the perfect reflector.
    /// @param x  on the mechanism's default axis, in [0, 1]: sqrt(cos(theta)), u / 2, (1 + cos_scatter) / 2
    ModelXyz at(double x) const;

    /// Points at which doubling ended before the tolerance was met.
    std::size_t unsettled() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// What layers do to light of one polarisation; a metal base is part of them, any other is not.
struct ModelPowers {
    double reflectance = 0.0, transmittance = 0.0;              ///< of light from above
    double reflectance_below = 0.0, transmittance_below = 0.0;  ///< of light from below, in the substrate
};
/// @param mechanism  a film, stack or crystal; its spread does not count
/// @param sine  n sin(theta), the same in all media
ModelPowers layer_powers(const Mechanism& mechanism, double sine, double wavelength_nm, bool is_p);

/// The fraction of the light that enters layers at a wavelength which comes out again from a diffuse base below them,
/// over their transmittance: rho t / (1 - rho r), r and t for light that comes evenly from all directions below.
double base_factor(const Mechanism& mechanism, double wavelength_nm);

/// Facets whose normals are off the surface's by tau with density exp(-tau^2 / (2 tilt^2)) per solid angle, as an eye
/// sees them: each by the cosine beta at which it is seen, weighted with that cosine.
struct ModelFacet {
    double cos_beta = 1.0, share = 0.0;  ///< the shares' sum is 1
};
std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg);

/// |S1|^2, |S2|^2 and cross-sections over pi r^2 of a sphere, in double (Bohren & Huffman 1983, chapter 4 and appendix
/// A): for size parameters from 0.05 to 50.
struct ModelSphere {
    double q_sca = 0.0, q_ext = 0.0;
    std::vector<std::complex<double>> a, b;  ///< [n]; [0] is not used

    struct Amplitudes {
        std::complex<double> s1, s2;
    };
    Amplitudes amplitudes(double cos_scatter) const;
};
ModelSphere model_sphere(double size_parameter, std::complex<double> relative_index);

}  // namespace nacre::reference
