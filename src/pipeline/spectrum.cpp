#include "pipeline/spectrum.h"

#include <cmath>
#include <numbers>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/optics/incidence.h"

namespace nacre {
namespace {

double largest_angle_deg(Quantity quantity) {
    switch (quantity) {
        case Quantity::cos_scatter:
            return 180.0;
        case Quantity::incidence:
        case Quantity::grating_u:
            break;
    }
    return 90.0;
}

}  // namespace

const Material& material_named(const Plan& plan, const std::string& name, const std::string& where) {
    std::vector<std::string> known;
    for (const Material& candidate : plan.materials) {
        if (candidate.name == name) return candidate;
        known.push_back(candidate.name);
    }
    throw Error(where + ": unknown material " + in_quotes(name) + "; known: " + known_like(name, known));
}

Geometry geometry_at_angle(const Mechanism& mechanism, double angle_deg) {
    switch (quantity_of(mechanism)) {
        case Quantity::grating_u:
            return Geometry::from_grating_u(std::sin(angle_deg * std::numbers::pi / 180.0));
        case Quantity::cos_scatter:
            return Geometry::from_cos_scatter(std::cos(angle_deg * std::numbers::pi / 180.0));
        case Quantity::incidence:
            break;
    }
    return Incidence::from_degrees(angle_deg);
}

void check_angle(double angle_deg, const Mechanism& mechanism, const std::string& where) {
    const double most_deg = largest_angle_deg(quantity_of(mechanism));
    if (angle_deg >= 0.0 && angle_deg <= most_deg) return;
    throw Error(where + ": angle " + number_text(angle_deg) + " is out of range; allowed [0, " + number_text(most_deg) +
                "] degrees");
}

void check_wavelength(const Material& material, double wavelength_nm, const std::string& text,
                      const std::string& where) {
    const auto unknown = unknown_at(material.mechanism, wavelength_nm);
    if (!unknown) return;
    throw Error(where + ": wavelength " + text + " nm lies outside what is known of " +
                (unknown->name.empty() ? "an index" : in_quotes(unknown->name)) + " in material " +
                in_quotes(material.name) + "; allowed [" + number_text(unknown->first_nm) + ", " +
                number_text(unknown->last_nm) + "] nm");
}

std::vector<double> every_nanometre(const Light& light) {
    const WavelengthGrid grid{static_cast<double>(light.settings.first_nm), static_cast<double>(light.settings.last_nm),
                              light.settings.last_nm - light.settings.first_nm + 1};
    std::vector<double> wavelengths_nm;
    for (int node = 0; node < grid.count; ++node) wavelengths_nm.push_back(grid.wavelength_nm(node));
    return wavelengths_nm;
}

ExactColour exact_colour_at(const Material& material, double angle_deg, const Light& light) {
    const Xyz seen = reflectance_xyz(material.mechanism, geometry_at_angle(material.mechanism, angle_deg), light);
    return {seen, adapt(light.adaptation, seen)};
}

}  // namespace nacre
