#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "reference/colour.h"
#include "reference/scene.h"

namespace nacre::reference {

/// The colour of any mechanism with any of its effects, by the textbook and by brute force. It reads the plain structs
/// that say what a material is, and calls nothing of src/.
///
/// What it does not know: graded layers, spreads of more than two layers: then it throws std::runtime_error. Spreads of
/// layers that are mirrors on both sides, as free films are at grazing, are too much for it.
class Model {
public:
    /// @param tolerance  CIEDE2000 by which twice as many wavelengths may still change a colour
    /// @param scale  at which colours are compared; 0: that of the brightest asked for
    explicit Model(const ModelScene& scene, double tolerance = 1e-6, double scale = 0.0);
    ~Model();
    Model(Model&&) noexcept;
    Model& operator=(Model&&) noexcept;

    /// @param x,y  LUT coordinates in [0, 1]; y does not matter without a second axis
    ModelXyz at(double x, double y = 0.0) const;

    /// Of layers without facets, however narrow their resonances are. @param own_x  sqrt(cos(theta))
    /// @param tolerance  of reflectance times nanometres, in each nanometre
    ModelXyz resolved(double own_x, double y, double tolerance) const;

    /// Of layers: faces times wavelengths that a colour takes at least.
    double cost() const;
    /// Points at which doubling ended before the tolerance was met.
    std::size_t unconverged() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Of a film or stack without a base: the fraction of unpolarised light that it reflects.
double reflectance(const Mechanism& mechanism, double cos_theta, double wavelength_nm);

/// Coordinates on x at which some medium of a film or stack begins to reflect totally, at 450, 550 and 650 nm: the
/// colour has a kink there.
std::vector<double> critical_coordinates(const ModelScene& scene);

}  // namespace nacre::reference
