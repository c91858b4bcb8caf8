#include "nacre/optics/scatter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "nacre/base/gauss_points.h"
#include "nacre/optics/structure_factor.h"

namespace nacre {
namespace {

using std::numbers::pi;
constexpr double largest_hard_fraction = 0.6;

double sphere_volume(double radius_nm) {
    return 4.0 / 3.0 * pi * radius_nm * radius_nm * radius_nm;
}

// The variance of ln r of log-normal radii.
double log_variance(const Scatter& scatter) {
    return std::log1p(scatter.radius_spread * scatter.radius_spread);
}

double wave_number_in_medium(const Scatter& scatter, double wavelength_nm) {
    return 2.0 * pi * scatter.medium.at(wavelength_nm).real() / wavelength_nm;
}

double hard_radius_nm(const Scatter& scatter) {
    return scatter.hard_radius_nm > 0.0 ? scatter.hard_radius_nm : scatter.radius_nm;
}

// Points of a quadrature over angles of amplitudes times structure factor. The first are polynomials of a degree that
// is twice their terms'; to the second the angles' spacing, times k diameter, must be small beside the distance of its
// nearest pole from the real axis (0.27 at a fraction of 0.6, 1.4 at 0.3, 4.1 at 0.05; this is a bit less everywhere).
// What is left is of the size of exp(-20). Of k diameter the waves of small spheres use a part, and need fewer (found
// by comparing with three times as many: up to a size parameter of 2, 1e-13 is left everywhere).
int points_over_angles(int terms, double hard_size_parameter, double hard_fraction) {
    const double from_freezing = largest_hard_fraction - hard_fraction;
    const double pole_distance = 0.26 + 11.0 * from_freezing * from_freezing;
    const double per_distance = std::clamp(8.0 + 2.4 * hard_size_parameter, 10.0, 20.0);
    return terms + 8 + static_cast<int>(per_distance * hard_size_parameter / pole_distance);
}

}  // namespace

double hard_sphere_fraction(const Scatter& scatter) {
    const double ratio = hard_radius_nm(scatter) / scatter.radius_nm;
    return scatter.volume_fraction * ratio * ratio * ratio;
}

double largest_size_parameter(const Scatter& scatter, double wavelength_nm, int sizes) {
    double largest_nm = scatter.radius_nm;
    if (scatter.model != ScatterModel::rayleigh)
        largest_nm = ScatterSolver::size_classes(scatter, sizes).back().radius_nm;
    return wave_number_in_medium(scatter, wavelength_nm) * largest_nm;
}

ScatterSolver::ScatterSolver(const Scatter& scatter, std::span<const double> wavelengths_nm, int sizes)
    : model_(scatter.model), lights_(wavelengths_nm.size()) {
    assert(scatter.radius_nm > 0.0 && scatter.volume_fraction > 0.0 && scatter.thickness_um > 0.0 && sizes >= 1);
    if (model_ != ScatterModel::rayleigh) sizes_ = size_classes(scatter, sizes);
    Room room;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        Light& light = lights_[i];
        light.wave_number = wave_number_in_medium(scatter, wavelengths_nm[i]);
        const RefractiveIndex relative =
            scatter.particle.at(wavelengths_nm[i]) / scatter.medium.at(wavelengths_nm[i]).real();
        if (model_ == ScatterModel::rayleigh)
            prepare_dipoles(scatter, relative, light);
        else
            prepare_spheres(relative, light, room);
    }
    if (model_ == ScatterModel::quasi_ordered) {
        hard_diameter_nm_ = 2.0 * hard_radius_nm(scatter);
        hard_fraction_ = std::min(hard_sphere_fraction(scatter), largest_hard_fraction);
        order_ = HardSpheres(hard_fraction_);
        integrate_order();
    }
    const double thickness_nm = 1e3 * scatter.thickness_um;
    for (Light& light : lights_) {
        const double extinction = light.scattered_per_nm + light.absorbed_per_nm;
        if (extinction == 0.0) continue;
        light.depth = extinction * thickness_nm;
        light.albedo = light.scattered_per_nm / extinction;
        const double square = light.wave_number * light.wave_number;
        light.scale = 4.0 * pi / square / extinction * -std::expm1(-light.depth);
    }
}

std::vector<ScatterSolver::Size> ScatterSolver::size_classes(const Scatter& scatter, int sizes) {
    if (sizes == 1 || scatter.radius_spread == 0.0)
        return {{scatter.radius_nm, scatter.volume_fraction / sphere_volume(scatter.radius_nm)}};
    // The volume of log-normal particles, too, is log-normal: 3 variances higher (Hatch & Choate 1929).
    const double variance = log_variance(scatter);
    const double median_nm = scatter.radius_nm * std::exp((3.0 - 0.5) * variance);
    std::vector<Size> classes;
    for (const GaussPoint& point : normal_points(sizes)) {
        const double radius_nm = median_nm * std::exp(std::sqrt(variance) * point.at);
        classes.push_back({radius_nm, scatter.volume_fraction * point.weight / sphere_volume(radius_nm)});
    }
    return classes;
}

// Dipoles. C_sca = 8/3 pi k^4 r^6 |alpha|^2 and C_abs = 4 pi k r^3 Im(alpha), alpha = (m^2 - 1) / (m^2 + 2); of
// log-normal radii the mean of r^6 is r^6 exp(15 variance), that of r^3 is r^3 exp(3 variance).
void ScatterSolver::prepare_dipoles(const Scatter& scatter, RefractiveIndex relative, Light& light) {
    const RefractiveIndex above = (relative - 1.0) * (relative + 1.0);
    const RefractiveIndex below = relative * relative + 2.0;
    // Never 0: no double has a square of exactly 2. A resonance that nothing damps is large, and light all scattered.
    const double square = std::norm(below);
    const double size_parameter = light.wave_number * scatter.radius_nm;
    const double cube = size_parameter * size_parameter * size_parameter;
    const double moments_ratio = std::exp(12.0 * log_variance(scatter));  // <r^6> / <r^3> over that of the mean radius
    // Im(above / below) = 3 Im(m^2) / |below|^2, without a difference.
    const double absorbing = 6.0 * relative.real() * relative.imag() / square;
    const double volume_nm3 = sphere_volume(scatter.radius_nm);
    const double spheres_per_nm3 = scatter.volume_fraction / volume_nm3;  // if all were of the mean volume's r^3
    light.dipole = spheres_per_nm3 * cube * cube * moments_ratio * std::norm(above) / square;
    const double area = 1.0 / light.wave_number / light.wave_number;
    light.scattered_per_nm = 8.0 / 3.0 * pi * area * light.dipole;
    light.absorbed_per_nm = 4.0 * pi * area * spheres_per_nm3 * cube * absorbing;
}

void ScatterSolver::prepare_spheres(RefractiveIndex relative, Light& light, Room& room) {
    MieSphere& sphere = room.sphere;
    room.sums.clear();
    room.differences.clear();
    light.ends.reserve(sizes_.size());
    for (const Size& size : sizes_) {
        mie_sphere(light.wave_number * size.radius_nm, relative, room.functions, sphere);
        for (std::size_t n = 0; n < sphere.a.size(); ++n) {
            room.sums.push_back(sphere.a[n] + sphere.b[n]);
            room.differences.push_back(sphere.a[n] - sphere.b[n]);
        }
        light.ends.push_back(room.sums.size());
        const double area_per_nm = size.per_nm3 * pi * size.radius_nm * size.radius_nm;
        light.scattered_per_nm += area_per_nm * sphere.q_sca;
        light.absorbed_per_nm += area_per_nm * sphere.q_abs;
        most_terms_ = std::max(most_terms_, static_cast<int>(sphere.a.size()));
    }
    light.sums = room.sums;
    light.differences = room.differences;
}

// The mean particle's series: what the particles' waves have in common.
ScatterSolver::Light ScatterSolver::mean_sphere(const Light& light) const {
    Light mean;
    mean.sums.resize(static_cast<std::size_t>(most_terms_));
    mean.differences.resize(mean.sums.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
        for (std::size_t n = 0; begin + n < light.ends[i]; ++n) {
            mean.sums[n] += sizes_[i].per_nm3 * light.sums[begin + n];
            mean.differences[n] += sizes_[i].per_nm3 * light.differences[begin + n];
        }
        begin = light.ends[i];
    }
    return mean;
}

// What order adds to scattering, or takes: its integral over all directions. It touches only what the waves have in
// common, so that one series per wavelength does.
void ScatterSolver::integrate_order() {
    double largest_wave_number = 0.0;
    for (const Light& light : lights_) largest_wave_number = std::max(largest_wave_number, light.wave_number);
    const int count = points_over_angles(most_terms_, 0.5 * largest_wave_number * hard_diameter_nm_, hard_fraction_);
    double particles = 0.0;
    for (const Size& size : sizes_) particles += size.per_nm3;
    std::vector<Light> means;
    for (const Light& light : lights_) means.push_back(mean_sphere(light));
    std::vector<double> added(lights_.size());
    for (const GaussPoint& point : gauss_legendre(count)) {
        const AngularFunctions angles = angular_functions(point.at, most_terms_);
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            const ScatteringAmplitudes mean = amplitudes(means[i], 0, means[i].sums.size(), angles);
            const double common = (std::norm(mean.s1) + std::norm(mean.s2)) / particles;
            added[i] += point.weight * pi * common * order_less_one(lights_[i], point.at);
        }
    }
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        Light& light = lights_[i];
        light.scattered_per_nm =
            std::max(light.scattered_per_nm + added[i] / light.wave_number / light.wave_number, 0.0);
    }
}

// The structure factor less 1.
double ScatterSolver::order_less_one(const Light& light, double cos_scatter) const {
    const double half_sine = std::sqrt(std::max(0.5 * (1.0 - cos_scatter), 0.0));  // sin(angle / 2)
    const double q_diameter = 2.0 * light.wave_number * half_sine * hard_diameter_nm_;
    return order_.structure_factor(q_diameter) - 1.0;
}

// As mie_amplitudes(), of the size whose terms are there.
ScatteringAmplitudes ScatterSolver::amplitudes(const Light& light, std::size_t begin, std::size_t end,
                                               const AngularFunctions& angles) {
    std::complex<double> sum;         // (S1 + S2) / 2
    std::complex<double> difference;  // (S1 - S2) / 2
    for (std::size_t i = begin; i < end; ++i) {
        sum += light.sums[i] * angles.sum[i - begin];
        difference += light.differences[i] * angles.difference[i - begin];
    }
    return {sum + difference, sum - difference};
}

ScatterSolver::Intensity ScatterSolver::intensity(const Light& light, double cos_scatter,
                                                  const AngularFunctions& angles) const {
    if (model_ == ScatterModel::rayleigh) return {light.dipole, light.dipole * cos_scatter * cos_scatter};
    Intensity sum{0.0, 0.0};
    std::complex<double> coherent_s;
    std::complex<double> coherent_p;
    double count = 0.0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
        const ScatteringAmplitudes at = amplitudes(light, begin, light.ends[i], angles);
        begin = light.ends[i];
        const double weight = sizes_[i].per_nm3;
        sum.s += weight * std::norm(at.s1);
        sum.p += weight * std::norm(at.s2);
        coherent_s += weight * at.s1;
        coherent_p += weight * at.s2;
        count += weight;
    }
    if (model_ == ScatterModel::mie) return sum;
    const double order = order_less_one(light, cos_scatter);
    // By Cauchy and Schwarz the coherent part is at most all of it, and order at least -1: but for rounding.
    return {std::max(sum.s + std::norm(coherent_s) / count * order, 0.0),
            std::max(sum.p + std::norm(coherent_p) / count * order, 0.0)};
}

void ScatterSolver::seen(double cos_scatter, Polarisation polarisation, std::span<double> out) const {
    assert(cos_scatter >= -1.0 && cos_scatter <= 1.0 && out.size() == lights_.size());
    const AngularFunctions angles = angular_functions(cos_scatter, most_terms_);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Intensity at = intensity(lights_[i], cos_scatter, angles);
        const double counted = polarisation == Polarisation::s   ? at.s
                               : polarisation == Polarisation::p ? at.p
                                                                 : 0.5 * (at.s + at.p);
        out[i] = lights_[i].scale * counted;
    }
}

std::size_t ScatterSolver::terms() const {
    if (model_ == ScatterModel::rayleigh) return lights_.size();
    std::size_t sum = 0;
    for (const Light& light : lights_) sum += light.sums.size();
    return sum;
}

}  // namespace nacre
