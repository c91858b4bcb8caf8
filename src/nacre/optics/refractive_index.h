#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/sampled_curve.h"

namespace nacre {

/// n + ik at one wavelength, k >= 0, for fields that go as exp(-i omega t).
using RefractiveIndex = std::complex<double>;

/// The index of a surface with a known reflectance R at normal incidence from vacuum, and with an edge tint g:
///
///     n = g (1 - R) / (1 + R) + (1 - g) (1 + sqrt R) / (1 - sqrt R),   k^2 = (R (n + 1)^2 - (n - 1)^2) / (1 - R)
///
/// g = 0 is a dielectric (k = 0), and the larger g, the brighter the surface near grazing.
/// Source: Gulbrandsen 2014, Artist Friendly Metallic Fresnel, Journal of Computer Graphics Techniques 3(4), 64-72.
/// @param reflectance  R, in [0, 1)
/// @param edge_tint    g, in [0, 1]
RefractiveIndex metal_index(double reflectance, double edge_tint);
/// The same with n = 1, that is g = (1 + R) / (1 + sqrt R): k = 2 sqrt(R / (1 - R)).
RefractiveIndex metal_index(double reflectance);

/// A metal as renderers describe it, in linear Rec.709. What it stands for: pick/coloured_metal.h.
struct MetalColour {
    std::array<double, 3> f0{};                        ///< its colour at normal incidence, in [0, 1)
    std::optional<std::array<double, 3>> edge_tint{};  ///< in [0, 1]; none: n = 1
    friend bool operator==(const MetalColour&, const MetalColour&) = default;
};

/// One of the dispersion formulas that refractiveindex.info numbers 1 to 9.
///
/// L: wavelength in micrometres. Coefficients that are left out are 0, and so is a term whose strength is 0.
///
///     1 Sellmeier    n^2 = 1 + C1 + C2 L^2 / (L^2 - C3^2) + C4 L^2 / (L^2 - C5^2) + ...
///     2 Sellmeier    n^2 = 1 + C1 + C2 L^2 / (L^2 - C3) + C4 L^2 / (L^2 - C5) + ...
///     3 polynomial   n^2 = C1 + C2 L^C3 + C4 L^C5 + ...
///     4 mixed        n^2 = C1 + C2 L^C3 / (L^2 - C4^C5) + C6 L^C7 / (L^2 - C8^C9) + C10 L^C11 + C12 L^C13 + ...
///     5 Cauchy       n = C1 + C2 L^C3 + C4 L^C5 + ...
///     6 gases        n = 1 + C1 + C2 / (C3 - L^-2) + C4 / (C5 - L^-2) + ...
///     7 Herzberger   n = C1 + C2 / (L^2 - 0.028) + C3 / (L^2 - 0.028)^2 + C4 L^2 + C5 L^4 + C6 L^6
///     8 retro        (n^2 - 1) / (n^2 + 2) = C1 + C2 L^2 / (L^2 - C3) + C4 L^2
///     9 exotic       n^2 = C1 + C2 / (L^2 - C3) + C4 (L - C5) / ((L - C5)^2 + C6)
///
/// Source: "Dispersion formulas" in the documents of the refractiveindex.info database, commit ff11b589.
struct IndexFormula {
    int number = 5;                    ///< [1, 9]
    std::vector<double> coefficients;  ///< C1, C2, ...; at most most_coefficients(number)

    /// n; not finite where the formula has none (the root of a negative number, a pole).
    /// @param wavelength_nm  vacuum wavelength, > 0
    double at(double wavelength_nm) const;
    friend bool operator==(const IndexFormula&, const IndexFormula&) = default;
};

/// How many coefficients the formula has at most. @pre formula_number in [1, 9]
std::size_t most_coefficients(int formula_number);

/// A material: its refractive index against wavelength.
struct IndexCurve {
    std::string name;  ///< for messages: "water", "Malitson.yml"
    std::variant<double, IndexFormula, SampledCurve> n = 1.0;
    std::variant<double, SampledCurve> k = 0.0;  ///< >= 0
    double first_nm = 0.0;                       ///< what is known: where both n and k are
    double last_nm = 1e6;
    bool is_shipped = false;             ///< whether it is a shipped material, which its name identifies
    bool holds_outside = false;          ///< whether the end values continue beyond the ends
    std::optional<MetalColour> metal{};  ///< what n and k were made from, if a colour

    /// Tables are linear between their nodes, n and k each on its own.
    /// @pre wavelength_nm is in [first_nm, last_nm], or holds_outside (then the nearer end counts)
    RefractiveIndex at(double wavelength_nm) const;
    /// Whether k is 0 at every wavelength of its table.
    bool is_lossless() const;
    /// Whether n or k depend on the wavelength: tables that say the same at every node do not, nor do
    /// formulas of C1 alone.
    bool is_dispersive() const;
    friend bool operator==(const IndexCurve&, const IndexCurve&) = default;
};

/// What a scene may give as a refractive index: a number, or a material.
struct Index {
    RefractiveIndex constant{1.0, 0.0};       ///< counts if there is no curve
    std::shared_ptr<const IndexCurve> curve;  ///< null: constant

    Index() = default;
    Index(double n) : constant(n, 0.0) {}              // NOLINT: a number is an index
    Index(RefractiveIndex index) : constant(index) {}  // NOLINT
    explicit Index(std::shared_ptr<const IndexCurve> material) : curve(std::move(material)) {}

    bool is_constant() const { return curve == nullptr; }
    bool is_dispersive() const { return curve != nullptr && curve->is_dispersive(); }
    RefractiveIndex at(double wavelength_nm) const { return curve ? curve->at(wavelength_nm) : constant; }
    /// The same number, or the same material: the very object, not an equal one.
    friend bool operator==(const Index&, const Index&) = default;
};

}  // namespace nacre
