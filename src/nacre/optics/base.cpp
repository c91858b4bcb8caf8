#include "nacre/optics/base.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

struct Reflectance {
    double wavelength_nm;

    double operator()(const GreyBase& base) const { return base.reflectance; }
    double operator()(const RgbBase& base) const {
        const double t = (wavelength_nm - 360.0) / 470.0;
        const double x = (base.coefficients[0] * t + base.coefficients[1]) * t + base.coefficients[2];
        return 0.5 + 0.5 * x / std::sqrt(1.0 + x * x);
    }
    double operator()(const SpectrumBase& base) const {
        const auto& nm = base.reflectance.wavelength_nm;
        return base.reflectance.at(std::clamp(wavelength_nm, nm.front(), nm.back()));
    }
    double operator()(const PigmentBase& base) const {
        const double k = base.pigment.at(wavelength_nm).imag();
        const double absorption_per_um = 2.0 * base.share * 4.0 * std::numbers::pi * k / (1e-3 * wavelength_nm);
        const double q = absorption_per_um / base.scattering_per_um;
        return 1.0 / (1.0 + q + std::sqrt(q * (q + 2.0)));  // of the formula's two roots, without its cancellation
    }
    double operator()(const MetalBase&) const { return 0.0; }
};

}  // namespace

double diffuse_reflectance(const Base& base, double wavelength_nm) {
    return std::visit(Reflectance{wavelength_nm}, base);
}

}  // namespace nacre
