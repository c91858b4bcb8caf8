#include "pipeline/spectrum.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/optics/incidence.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/scene/table.h"
#include "nacre/shade/spectral_sampling.h"

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

void set_parameter(Mechanism& mechanism, const std::string& name, double value, const Where& where) {
    Axis point;
    try {
        point = parameter_axis(mechanism, name, value, value);
    } catch (const Error& error) {
        throw Error(where.text() + ": " + error.what());
    }
    const Allowed& allowed = point.parameter.allowed;
    if (!(value >= allowed.low && value <= allowed.high)) {
        throw Error(where.text() + ": " + name + " = " + number_text(value) + " is out of range; allowed [" +
                    limit_text(allowed.low) + ", " + limit_text(allowed.high) + "]" +
                    (allowed.unit.empty() ? "" : " " + std::string(allowed.unit)));
    }
    check_axis(point, mechanism, Table("", where), where);
    point.parameter.set(mechanism, value);
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

Geometry geometry_at_u(const Material& material, double u, const std::string& where) {
    if (quantity_of(material.mechanism) != Quantity::grating_u) {
        throw Error(where + ": material " + in_quotes(material.name) + " is a " +
                    std::string(mechanism_name(material.mechanism)) +
                    ", and only a grating has grating_u; give angle_deg");
    }
    constexpr double most = 2.0;
    if (!(std::abs(u) <= most))
        throw Error(where + ": grating_u " + number_text(u) + " is out of range; allowed [-2, 2]");
    return Geometry::from_grating_u(std::abs(u));
}

void check_colour(const std::string& material, const Mechanism& mechanism, const Light& light,
                  const std::string& where) {
    if (light.settings.wavelengths) return;
    const double fringes = fringe_count(mechanism, light.settings);
    if (fringes <= most_fringes) return;
    throw Error(where + ": the layers of material " + in_quotes(material) + " are so thick that " +
                significant_text(fringes, 3) + " fringes lie in range_nm, and a colour can have at most " +
                number_text(most_fringes) + "; in a stack, mark thick layers with incoherent = true");
}

std::vector<double> even_steps(double first, double last, double step) {
    constexpr double decimals = 1e9;
    const auto count = static_cast<std::size_t>(std::floor((last - first) / step + 1.0 / decimals)) + 1;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(std::round((first + static_cast<double>(i) * step) * decimals) / decimals);
    return numbers;
}

std::vector<double> wavelengths_of(const Light& light, double step_nm) {
    return even_steps(light.settings.first_nm, light.settings.last_nm, step_nm);
}

ExactColour exact_colour_at(const Mechanism& mechanism, const Geometry& geometry, const Light& light,
                            ExactColours& colours) {
    const Xyz seen = colours.at(mechanism, geometry);
    return {seen, adapt(light.adaptation, seen)};
}

}  // namespace nacre
