#pragma once

#include <string>
#include <vector>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/base/where.h"
#include "nacre/colour/colour_types.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/plan.h"
#include "nacre/shade/spectra.h"

namespace nacre {

/// The material of a plan that has all materials.
/// @param where  for messages
/// @throws Error for an unknown name
const Material& material_named(const Plan& plan, const std::string& name, const std::string& where);

/// Gives a number of a mechanism, by the name that it has as an axis, another value.
/// @throws Error if there is no such number, or if it cannot have that value
void set_parameter(Mechanism& mechanism, const std::string& name, double value, const Where& where);

/// What one angle means to a mechanism. Of gratings it is the angle of the eye, with light along the normal; of
/// scattering the angle by which light is turned; of all others the angle of incidence.
Geometry geometry_at_angle(const Mechanism& mechanism, double angle_deg);

/// @throws Error if the mechanism has no such angle: allowed are 0 to 90 degrees, of scattering 0 to 180
void check_angle(double angle_deg, const Mechanism& mechanism, const std::string& where);

/// All that a grating can be seen at: u = sin theta_i + sin theta_o, of either sign.
/// @throws Error for any other mechanism, or beyond [-2, 2]
Geometry geometry_at_u(const Material& material, double u, const std::string& where);

/// @param text  the wavelength as the user wrote it
/// @throws Error if something that the material is made of is not known at that wavelength
void check_wavelength(const Material& material, double wavelength_nm, const std::string& text,
                      const std::string& where);

/// @throws Error if layers are so thick that no number of wavelengths resolves their fringes, so that they have spectra
/// but no colour
void check_colour(const std::string& material, const Mechanism& mechanism, const Light& light,
                  const std::string& where);

/// first, first + step, ... and not beyond last: each is the number that its nine decimals are read as.
/// @pre first <= last, step > 0
std::vector<double> even_steps(double first, double last, double step);

/// A light's wavelengths, `step_nm` apart.
std::vector<double> wavelengths_of(const Light& light, double step_nm);

/// A material's colour, by the exact model.
struct ExactColour {
    Xyz seen;     ///< under the scene's light
    Xyz adapted;  ///< relative to D65
};
ExactColour exact_colour_at(const Mechanism& mechanism, const Geometry& geometry, const Light& light,
                            ExactColours& colours);

}  // namespace nacre
