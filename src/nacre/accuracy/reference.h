#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/xyz_curve.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// What a bake is checked against: the true colour of a job at one point, by an independent method.
///
/// Reflectance at single wavelengths, integrated by Gauss-Legendre quadrature over every nanometre, against weights
/// made anew from the CIE's tables and the illuminant; of a lamp with fine lines also from one of its nodes to the
/// next. It shares a mechanism's formulas with the bake, but nothing of how spectra become XYZ: no closed form, no
/// moments, no nodes, no grid, no SIMD. Every effect of the scene is there, whatever the bake leaves out. Layers of up
/// to `most_scalar_layers` are solved by the solver's scalar reference implementation, more by the solver itself at
/// other wavelengths; uneven ones have the bake's samples, whose number is part of the model. A grating's lines are
/// walked through wave by wave. A base's directions and a surface's facets are summed by midpoint rules with far more
/// points.
class Reference {
public:
    /// @param job  has to outlive the reference
    explicit Reference(const Job& job);

    /// XYZ relative to D65, Y = 1 for the perfect reflector. `wavelengths` of the scene do not count: the truth has no
    /// nodes. Not to be asked by two threads at once: what the last material took is kept.
    /// Accuracy: 1e-9 for bands of 4 nm and more, 1e-7 for narrower ones; 1e-6 for layers, 1e-5 for the rest.
    Xyz at(double x, double y = 0.0) const;

    static constexpr double most_scalar_layers = 40.0;

private:
    /// A wavelength and the length that it stands for.
    struct Wave {
        double nm;
        double length_nm;
    };

    Xyz flat(const Mechanism& mechanism, const Geometry& geometry) const;
    Xyz tilted(const Mechanism& mechanism, const Incidence& incidence) const;
    Xyz layered(const Mechanism& mechanism, const Incidence& incidence) const;
    Xyz lines(const Grating& grating, double u) const;
    Xyz scattered(const Mechanism& mechanism, double cos_scatter) const;
    Xyz measured(const MeasuredSpectra& spectra, const Incidence& incidence) const;
    Xyz integral(const Lobe& lobe) const;
    Xyz weight_at(double nm) const;
    double next_kink(double nm) const;
    const std::vector<double>& base_table(const Mechanism& mechanism, const LayerEnsemble& ensemble) const;

    const Job& job_;
    std::vector<Xyz> weights_;      // per whole nanometre; of a lamp with fine lines without its power
    std::vector<double> kinks_nm_;  // ascending: between them the weights are smooth
    bool has_fine_lines_;
    glm::dmat3 adaptation_;

    // Of the last material, kept for the next angle.
    mutable std::optional<std::pair<Mechanism, XyzCurve>> facets_;
    mutable std::optional<std::pair<Mechanism, std::vector<double>>> base_;
    struct Scattering;
    mutable std::shared_ptr<const Scattering> scattering_;
};

}  // namespace nacre
