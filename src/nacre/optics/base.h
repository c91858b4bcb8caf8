#pragma once

#include <array>
#include <string>
#include <variant>

#include "nacre/base/sampled_curve.h"
#include "nacre/optics/refractive_index.h"

namespace nacre {

/// A reflectance that does not depend on the wavelength, in [0, 1].
struct GreyBase {
    double reflectance = 0.0;
    friend bool operator==(const GreyBase&, const GreyBase&) = default;
};

/// The smooth reflectance whose colour under D65 is a given linear Rec.709 one: a sigmoid of a parabola over wavelength
/// (Jakob and Hanika 2019, A Low-Dimensional Function Space for Efficient Spectral Upsampling).
struct RgbBase {
    std::array<double, 3> rgb{};
    std::array<double, 3> coefficients{};  ///< of ((nm - 360) / 470)^2, its root, 1
    friend bool operator==(const RgbBase&, const RgbBase&) = default;
};

/// A table of reflectance, straight between its wavelengths and held beyond them.
struct SpectrumBase {
    SampledCurve reflectance;
    friend bool operator==(const SpectrumBase&, const SpectrumBase&) = default;
};

/// An opaque layer of a scattering medium with an absorbing pigment in it (Kubelka and Munk 1931): the reflectance is
/// 1 + q - sqrt(q^2 + 2 q), q = K / S, K = 2 * share * 4 pi k / wavelength.
struct PigmentBase {
    Index pigment;
    double scattering_per_um = 1.0;  ///< S, > 0
    double share = 1.0;              ///< of the pigment in the volume, in [0, 1]
    friend bool operator==(const PigmentBase&, const PigmentBase&) = default;
};

/// A smooth metal: no scattering, it reflects light only in the mirror direction.
struct MetalBase {
    Index metal;
    friend bool operator==(const MetalBase&, const MetalBase&) = default;
};

/// What lies below the layers, in their substrate. All but a metal reflect evenly in all directions (Lambert).
using Base = std::variant<GreyBase, RgbBase, SpectrumBase, PigmentBase, MetalBase>;

/// Of a base that is no metal: the fraction of light that it reflects, in [0, 1].
double diffuse_reflectance(const Base& base, double wavelength_nm);

}  // namespace nacre
