#pragma once

#include <string>
#include <vector>

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

/// What one angle means to a mechanism. Of gratings it is the angle of the eye, with light along the normal; of
/// scattering the angle by which light is turned; of all others the angle of incidence.
Geometry geometry_at_angle(const Mechanism& mechanism, double angle_deg);

/// @throws Error if the mechanism has no such angle: allowed are 0 to 90 degrees, of scattering 0 to 180
void check_angle(double angle_deg, const Mechanism& mechanism, const std::string& where);

/// @param text  the wavelength as the user wrote it
/// @throws Error if something that the material is made of is not known at that wavelength
void check_wavelength(const Material& material, double wavelength_nm, const std::string& text,
                      const std::string& where);

/// Every nanometre of a scene's light.
std::vector<double> every_nanometre(const Light& light);

/// A material's colour at an angle, by the exact model.
struct ExactColour {
    Xyz seen;     ///< under the scene's light
    Xyz adapted;  ///< relative to D65
};
ExactColour exact_colour_at(const Material& material, double angle_deg, const Light& light);

}  // namespace nacre
