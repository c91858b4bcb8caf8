#pragma once

#include "nacre/bake/plan.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// What a bake is checked against: the true colour of a job at one point, by a road of its own.
///
/// Reflectance at single wavelengths, integrated by Gauss-Legendre quadrature over every nanometre, against weights
/// made anew from the CIE's tables and the illuminant. It shares a palette's formulas with the bake, but nothing of
/// how spectra become XYZ: no closed form, no moments, no nodes, no grid, no SIMD. Films and stacks of up to
/// `most_twin_layers` are solved by the solver's simple twin, larger ones by the solver itself at other wavelengths;
/// irregular ones have the bake's realisations, whose number is part of the model.
class Reference {
public:
    /// @param job  has to outlive the reference
    explicit Reference(const Job& job);

    /// XYZ relative to D65, Y = 1 for the perfect reflector. `wavelengths` of the scene do not count: the truth has no
    /// nodes.
    /// Accuracy: 1e-9 for bands of 4 nm and more, 1e-7 for narrower ones; 1e-6 for films and stacks.
    Xyz at(double x, double y = 0.0) const;

    static constexpr double most_twin_layers = 40.0;

private:
    Xyz layered(const Mechanism& mechanism, const Incidence& incidence) const;
    Xyz integral(const Lobe& lobe) const;
    Xyz weight_at(double nm) const;

    const Job& job_;
    std::vector<Xyz> weights_;  // per whole nanometre
    glm::dmat3 adaptation_;
};

}  // namespace nacre
