#include <cmath>
#include <numbers>
#include <utility>

#include "reference/layers.h"
#include "reference/materials.h"

namespace nacre::reference {
namespace {

double diffuse(const Base& base, double nm) {
    if (const auto* grey = std::get_if<GreyBase>(&base)) return grey->reflectance;
    if (const auto* rgb = std::get_if<RgbBase>(&base)) {
        const double t = (nm - 360.0) / 470.0;
        const double x = rgb->coefficients[0] * t * t + rgb->coefficients[1] * t + rgb->coefficients[2];
        return 0.5 * (1.0 + x / std::hypot(1.0, x));
    }
    if (const auto* spectrum = std::get_if<SpectrumBase>(&base)) return linear_at(spectrum->reflectance, nm, true);
    const auto& pigment = std::get<PigmentBase>(base);
    const double k_per_um =
        2.0 * pigment.share * 4.0 * std::numbers::pi * index_at(pigment.pigment, nm).imag() / (nm / 1000.0);
    const double q = k_per_um / pigment.scattering_per_um;
    return 1.0 + q - std::sqrt(q * q + 2.0 * q);
}

}  // namespace

double base_factor(const std::vector<PlainLayers>& samples, const Base& base, double nm) {
    double reflected = 0.0, passed = 0.0;
    for (const PlainLayers& sample : samples) {
        const MediaAt media = media_at(sample, nm);
        // The more layers, the finer are their fringes over the angle.
        const int directions = 40 + 8 * static_cast<int>(sample.layers.size());
        const double n = media.index[1].real(), n_above = media.index[0].real();
        const double critical = n > n_above ? 1.0 - square(n_above / n) : 0.0;
        for (const auto& [from, to] : {std::pair{0.0, critical}, std::pair{critical, 1.0}}) {
            if (!(to > from)) continue;
            for (int i = 0; i < directions; ++i) {
                // Steps of the square of the cosine, crowded at either end: s^3 (10 - 15 s + 6 s^2), so that its slope
                // is 0 there twice over, and the midpoint rule errs by the fourth power of the step.
                const double s = (i + 0.5) / directions;
                const double cos_square = from + (to - from) * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
                const double weight = sample.share * (to - from) * 30.0 * square(s * (1.0 - s)) / directions;
                for (const bool is_p : {false, true}) {
                    const ModelPowers powers = powers_at(sample, media, {n, std::sqrt(cos_square), is_p});
                    reflected += 0.5 * weight * powers.reflectance_below;
                    passed += 0.5 * weight * powers.transmittance_below;
                }
            }
        }
    }
    const double rho = diffuse(base, nm);
    return rho * passed / (1.0 - rho * reflected);
}

double base_factor(const Mechanism& mechanism, double wavelength_nm) {
    return base_factor(thickness_samples_of(mechanism), *mechanism.effects.base, wavelength_nm);
}

}  // namespace nacre::reference
