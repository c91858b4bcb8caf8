#include "pipeline/metal_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "io/scene/shipped_materials.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/lut/rgb_colour_space.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

constexpr std::array<std::string_view, 5> shipped_metals{"ag", "al", "au", "cr", "cu"};
constexpr std::array<std::string_view, 3> main_spaces{"lin_rec709", "lin_p3d65", "lin_ap1"};
constexpr double edge_cosine = 1.0 / 7.0;
constexpr int degrees = 90;

// Colours of a bare metal, adapted to D65.
struct MetalColours {
    std::vector<Xyz> at_degrees;  // 0 to 90
    Xyz at_edge;
};

MetalColours colours_of(const Index& metal) {
    const GridWeights weights = make_grid_weights(
        make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("D65")), WavelengthGrid{});
    const glm::dmat3 to_d65 = adaptation_matrix(Adaptation::bradford, weights.white, d65_white);
    const Mechanism bare = Stack{1.0, {}, metal, 0.0};
    const auto colour = [&](const Incidence& incidence) {
        return adapt(to_d65, to_xyz(weights, observed_spectrum(bare, incidence, WavelengthGrid{})));
    };
    MetalColours colours;
    for (int degree = 0; degree <= degrees; ++degree)
        colours.at_degrees.push_back(colour(Incidence::from_degrees(degree)));
    colours.at_edge = colour(Incidence::from_cos(edge_cosine));
    return colours;
}

glm::dvec3 schlick(const glm::dvec3& f0, double cosine) {
    return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5);
}

double edge_term(double cosine) {
    return cosine * std::pow(1.0 - cosine, 6);
}

std::array<double, 3> components(const glm::dvec3& rgb) {
    return {rgb.r, rgb.g, rgb.b};
}

MetalInSpace in_space(const MetalColours& colours, const KnownRgbSpace& space) {
    const glm::dmat3 to_rgb = *RgbColourSpace(space).linear_matrix();
    const glm::dmat3 to_xyz = glm::inverse(to_rgb);
    const auto rgb_of = [&](const Xyz& colour) { return to_rgb * glm::dvec3(colour.x, colour.y, colour.z); };
    const glm::dvec3 f0 = rgb_of(colours.at_degrees.front());
    const glm::dvec3 f82 = rgb_of(colours.at_edge);
    const glm::dvec3 edge = schlick(f0, edge_cosine);
    MetalInSpace row;
    row.space = space.name;
    row.f0 = components(f0);
    row.f82 = components(f82);
    row.tint = components(f82 / edge);
    for (int degree = 0; degree <= degrees; ++degree) {
        const double cosine = Incidence::from_degrees(degree).cos_theta;
        const auto error = [&](const glm::dvec3& rgb) {
            const glm::dvec3 xyz = to_xyz * rgb;
            const Xyz& truth = colours.at_degrees[static_cast<std::size_t>(degree)];
            return ciede2000(to_lab({xyz.x, xyz.y, xyz.z}, d65_white), to_lab(truth, d65_white));
        };
        const glm::dvec3 plain = schlick(f0, cosine);
        row.schlick_de00 = std::max(row.schlick_de00, error(plain));
        row.f82_de00 = std::max(row.f82_de00, error(plain - edge_term(cosine) / edge_term(edge_cosine) * (edge - f82)));
    }
    return row;
}

}  // namespace

std::vector<std::string> metal_names() {
    return {shipped_metals.begin(), shipped_metals.end()};
}

std::vector<MetalInSpace> metal_table() {
    std::vector<MetalInSpace> rows;
    for (const ListedName& material : shipped_material_list()) {
        if (std::find(shipped_metals.begin(), shipped_metals.end(), material.name) == shipped_metals.end()) continue;
        const MetalColours colours = colours_of(Index(shipped_material(material.name)));
        for (const std::string_view name : main_spaces) {
            for (const KnownRgbSpace& space : known_rgb_spaces()) {
                if (space.name != name) continue;
                rows.push_back(in_space(colours, space));
                rows.back().metal = material.name;
                rows.back().description = material.description;
            }
        }
    }
    return rows;
}

}  // namespace nacre
