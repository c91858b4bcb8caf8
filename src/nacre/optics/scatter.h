#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "nacre/optics/mie.h"
#include "nacre/optics/polarisation.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/optics/structure_factor.h"

namespace nacre {

/// How particles scatter.
enum class ScatterModel {
    rayleigh,       ///< far smaller than the wavelength
    mie,            ///< spheres of any size, far from each other
    quasi_ordered,  ///< spheres so close that they keep a distance: Mie times the hard-sphere structure factor
};

/// A layer of equal or nearly equal spheres in a medium, each of which light meets once.
struct Scatter {
    ScatterModel model = ScatterModel::rayleigh;
    Index particle;
    Index medium;                   ///< lossless
    double radius_nm = 100.0;       ///< mean, > 0
    double radius_spread = 0.0;     ///< standard deviation over mean of a log-normal distribution of radii, in [0, 0.5]
    double volume_fraction = 0.01;  ///< of the particles, in (0, 0.6]
    double hard_radius_nm = 0.0;    ///< of quasi_ordered: half of the least distance of two centres; 0: radius_nm
    double thickness_um = 10.0;     ///< of the layer, > 0

    friend bool operator==(const Scatter&, const Scatter&) = default;
};

/// The part of the volume that quasi-ordered particles keep to themselves: volume_fraction * (hard_radius_nm /
/// radius_nm)^3. The structure factor knows fractions up to 0.6, and takes what is above for 0.6: refuse that before.
double hard_sphere_fraction(const Scatter& scatter);

/// The largest 2 pi radius * index of the medium / wavelength among the spheres that a solver computes: what its time
/// goes by. Of rayleigh, which computes none, that of the mean radius: its formulas want it to be far below 1.
double largest_size_parameter(const Scatter& scatter, double wavelength_nm, int sizes);

/// Scattering at fixed wavelengths, prepared for evaluation at many angles.
///
/// What is seen at an angle is  albedo * phase function * (1 - exp(-optical depth)):  light that is scattered once,
/// with the phase function's mean over the sphere being 1, so that a layer that takes all light and sends it evenly in
/// every direction has 1. Each of the three depends on the wavelength. Of light that is polarised the mean over the
/// sphere is not 1 by itself: that of s and p together is, as what is seen of unpolarised light is half their sum.
///
/// Equations: Bohren & Huffman 1983, chapter 5 (rayleigh) and 4 (mie). The mean over log-normal radii is taken with
/// normal_points() of ln r, and over the particles' volume rather than their number: the same mean, with the points
/// where the light is scattered. (rayleigh: moments in closed form, whatever `sizes`.) Error of what is seen at 90
/// degrees from latex in water: 1e-5 from 8 points for size parameter 2.5 and spread 0.1, 1e-3 from 64 for 7 and 0.3.
///
/// quasi_ordered: particles' waves interfere as if all were at distances of hard spheres of one size, whatever their
/// own (decoupling approximation: Kotlarchyk & Chen 1983, Journal of Chemical Physics 79, 2461-2469):
/// mean |S|^2 + |mean S|^2 (structure factor - 1), which is |S|^2 times the structure factor where all are equal. What
/// is scattered altogether is the integral of that, and what is absorbed is as without order.
class ScatterSolver {
public:
    /// @param wavelengths_nm  vacuum wavelengths, > 0
    /// @param sizes  of the quadrature over the distribution of radii, >= 1; 1: the mean radius alone
    ScatterSolver(const Scatter& scatter, std::span<const double> wavelengths_nm, int sizes);

    /// Per wavelength, >= 0. @param cos_scatter  cosine of the angle between the light's old and new direction, in
    /// [-1, 1]. @param out  as many as wavelengths
    void seen(double cos_scatter, Polarisation polarisation, std::span<double> out) const;

    /// Of the layer at a wavelength of the constructor's, >= 0.
    double optical_depth(std::size_t wavelength) const { return lights_[wavelength].depth; }
    /// Scattered over scattered and absorbed light, in [0, 1]; 0 where there is neither.
    double albedo(std::size_t wavelength) const { return lights_[wavelength].albedo; }

    /// Mie coefficients, or dipoles, over all wavelengths and sizes: what a call of seen() costs.
    std::size_t terms() const;

private:
    struct Size {
        double radius_nm;
        double per_nm3;  // particles of this radius
    };
    struct Light {
        double wave_number = 0.0;  // in the medium, 1 / nm
        // a_n + b_n and a_n - b_n of one size after the other, and where each ends; none of rayleigh.
        std::vector<std::complex<double>> sums, differences;
        std::vector<std::size_t> ends;
        double dipole = 0.0;            // of rayleigh: |S|^2 of the particles in 1 nm^3, at 0 degrees
        double scattered_per_nm = 0.0;  // by the particles in 1 nm^3: cross-section, nm^2
        double absorbed_per_nm = 0.0;
        double depth = 0.0;
        double albedo = 0.0;
        double scale = 0.0;  // seen per |S|^2 of the particles in 1 nm^3
    };
    struct Room {
        MieRoom functions;
        MieSphere sphere;
        std::vector<std::complex<double>> sums, differences;
    };
    // |S|^2 of the particles in 1 nm^3, of s and of p.
    struct Intensity {
        double s, p;
    };

    static std::vector<Size> size_classes(const Scatter& scatter, int sizes);
    static void prepare_dipoles(const Scatter& scatter, RefractiveIndex relative, Light& light);
    void prepare_spheres(RefractiveIndex relative, Light& light, Room& room);
    Light mean_sphere(const Light& light) const;
    void integrate_order();
    double order_less_one(const Light& light, double cos_scatter) const;
    static ScatteringAmplitudes amplitudes(const Light& light, std::size_t begin, std::size_t end,
                                           const AngularFunctions& angles);
    Intensity intensity(const Light& light, double cos_scatter, const AngularFunctions& angles) const;
    friend double largest_size_parameter(const Scatter& scatter, double wavelength_nm, int sizes);

    ScatterModel model_;
    std::vector<Size> sizes_;
    std::vector<Light> lights_;
    int most_terms_ = 0;             // of a sphere
    double hard_diameter_nm_ = 0.0;  // of quasi_ordered
    double hard_fraction_ = 0.0;
    HardSpheres order_{0.0};
};

}  // namespace nacre
