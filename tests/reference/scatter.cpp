#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "reference/flat_colour.h"
#include "reference/materials.h"
#include "reference/spheres.h"

namespace nacre::reference {
namespace {

// Radii are a trapezium rule over their logarithm.

// Percus and Yevick's direct correlation in closed form (Kinning & Thomas 1984, Macromolecules 17, 1712, equations 9 to
// 11): S = 1 / (1 + 24 f G / A), A = q diameter.
double structure_factor(double f, double a) {
    if (a < 0.05) return square(square(1.0 - f)) / square(1.0 + 2.0 * f);  // where the closed form cancels
    const double alpha = square(1.0 + 2.0 * f) / square(square(1.0 - f));
    const double beta = -6.0 * f * square(1.0 + 0.5 * f) / square(square(1.0 - f));
    const double gamma = 0.5 * f * alpha;
    const double sine = std::sin(a), cosine = std::cos(a);
    const double g =
        alpha * (sine - a * cosine) / square(a) + beta * (2.0 * a * sine + (2.0 - a * a) * cosine - 2.0) / (a * a * a) +
        gamma *
            (-square(square(a)) * cosine + 4.0 * ((3.0 * a * a - 6.0) * cosine + (a * a * a - 6.0 * a) * sine + 6.0)) /
            (a * square(square(a)));
    return 1.0 / (1.0 + 24.0 * f * g / a);
}

class ScatterColour : public FlatColour {
public:
    ScatterColour(const Mechanism& mechanism, const ModelLight& light)
        : light_(light),
          scatter_(std::get<Scatter>(mechanism)),
          polarisation_(mechanism.effects.polarisation),
          hard_nm_(scatter_.hard_radius_nm > 0.0 ? scatter_.hard_radius_nm : scatter_.radius_nm) {
        hard_fraction_ = scatter_.volume_fraction * std::pow(hard_nm_ / scatter_.radius_nm, 3.0);
        set_sizes();
    }

    Triple at(double x, double /*y*/, double step_nm) const override {
        const WavelengthGrid& grid = light_.grid(step_nm);
        std::vector<At>& made = at_[step_nm];
        if (made.empty())
            for (const double nm : grid.nm) made.push_back(prepared(nm));
        std::vector<double> spectrum;
        for (const At& at : made) {
            const auto [s, p] = intensity(at, 2.0 * x - 1.0);
            const double mean = polarisation_ == Polarisation::s   ? s
                                : polarisation_ == Polarisation::p ? p
                                                                   : 0.5 * (s + p);
            spectrum.push_back(at.scale * mean);
        }
        return grid.sum(spectrum);
    }

private:
    struct Size {
        double radius_nm, per_nm3;
    };
    struct At {
        double wave_number = 0.0, scale = 0.0;
        Complex dipole;  // alpha / r^3 of rayleigh
        std::vector<ModelSphere> spheres;
    };

    // Log-normal numbers, mean radius and volume fraction as given.
    void set_sizes() {
        const double variance = std::log(1.0 + square(scatter_.radius_spread)), deviation = std::sqrt(variance);
        if (scatter_.radius_spread == 0.0) {
            sizes_ = {{scatter_.radius_nm, 1.0}};
        } else {
            const double step = scatter_.model == ScatterModel::rayleigh ? 0.1 : 0.2;
            // Volumes lie 3 deviations squared higher than numbers, what scatters 6: there the rule has to reach.
            for (double z = -5.0; z <= 6.0 * deviation + 5.0; z += step)
                sizes_.push_back(
                    {scatter_.radius_nm * std::exp(deviation * z - 0.5 * variance), std::exp(-0.5 * z * z)});
        }
        double volume = 0.0;
        for (const Size& size : sizes_)
            volume += size.per_nm3 * 4.0 / 3.0 * std::numbers::pi * std::pow(size.radius_nm, 3.0);
        for (Size& size : sizes_) size.per_nm3 *= scatter_.volume_fraction / volume;
    }

    At prepared(double nm) const {
        At at;
        const double medium = index_at(scatter_.medium, nm).real();
        at.wave_number = 2.0 * std::numbers::pi * medium / nm;
        const Complex m = index_at(scatter_.particle, nm) / medium;
        at.dipole = (m * m - 1.0) / (m * m + 2.0);
        double scattered = 0.0, absorbed = 0.0;
        for (const Size& size : sizes_) {
            const double x = at.wave_number * size.radius_nm;
            const double area = size.per_nm3 * std::numbers::pi * square(size.radius_nm);
            if (scatter_.model == ScatterModel::rayleigh) {
                scattered += area * 8.0 / 3.0 * std::pow(x, 4.0) * squared_magnitude(at.dipole);
                absorbed += area * 4.0 * x * at.dipole.imag();
                continue;
            }
            at.spheres.push_back(model_sphere(x, m));
            scattered += area * at.spheres.back().q_sca;
            absorbed += area * std::max(at.spheres.back().q_ext - at.spheres.back().q_sca, 0.0);
        }
        if (m.imag() == 0.0) absorbed = 0.0;
        if (scatter_.model == ScatterModel::quasi_ordered) {
            scattered = 0.0;
            constexpr int angles = 300;
            for (int i = 0; i < angles; ++i) {
                const double theta = std::numbers::pi * (i + 0.5) / angles;
                const auto [s, p] = intensity(at, std::cos(theta));
                scattered +=
                    std::numbers::pi * (s + p) * std::sin(theta) * std::numbers::pi / angles / square(at.wave_number);
            }
        }
        const double extinction = scattered + absorbed;
        const double depth = extinction * 1e3 * scatter_.thickness_um;
        // albedo times phase function is 4 pi / k^2 |S|^2 / extinction.
        at.scale = extinction > 0.0
                       ? (1.0 - std::exp(-depth)) * 4.0 * std::numbers::pi / square(at.wave_number) / extinction
                       : 0.0;
        return at;
    }

    // |S|^2 of the particles in 1 nm^3, s and p.
    std::pair<double, double> intensity(const At& at, double cos_scatter) const {
        double s = 0.0, p = 0.0, count = 0.0;
        Complex of_all_s, of_all_p;
        for (std::size_t i = 0; i < sizes_.size(); ++i) {
            ModelSphere::Amplitudes amplitudes;
            if (scatter_.model == ScatterModel::rayleigh) {
                const double cube = std::pow(at.wave_number * sizes_[i].radius_nm, 3.0);
                amplitudes = {Complex(0.0, -cube) * at.dipole, Complex(0.0, -cube * cos_scatter) * at.dipole};
            } else {
                amplitudes = at.spheres[i].amplitudes(cos_scatter);
            }
            s += sizes_[i].per_nm3 * squared_magnitude(amplitudes.s1);
            p += sizes_[i].per_nm3 * squared_magnitude(amplitudes.s2);
            of_all_s += sizes_[i].per_nm3 * amplitudes.s1;
            of_all_p += sizes_[i].per_nm3 * amplitudes.s2;
            count += sizes_[i].per_nm3;
        }
        if (scatter_.model != ScatterModel::quasi_ordered) return {s, p};
        const double q = 2.0 * at.wave_number * std::sqrt(std::max(0.5 * (1.0 - cos_scatter), 0.0));
        const double order = structure_factor(hard_fraction_, q * 2.0 * hard_nm_) - 1.0;
        return {s + order * squared_magnitude(of_all_s) / count, p + order * squared_magnitude(of_all_p) / count};
    }

    const ModelLight& light_;
    Scatter scatter_;
    Polarisation polarisation_;
    double hard_nm_ = 0.0, hard_fraction_ = 0.0;
    std::vector<Size> sizes_;
    mutable std::map<double, std::vector<At>> at_;
};

}  // namespace

std::unique_ptr<FlatColour> scatter_colour(const Mechanism& mechanism, const ModelLight& light) {
    return std::make_unique<ScatterColour>(mechanism, light);
}

}  // namespace nacre::reference
