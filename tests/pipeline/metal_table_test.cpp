// F0 and F82 of the shipped metals: Fresnel's equations and the model of the reference, with n + ik from publications.
#include "pipeline/metal_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "io/scene/shipped_materials.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/pick/coloured_metal.h"
#include "reference/colour.h"
#include "reference/light.h"
#include "reference/materials.h"

namespace nacre::test {
namespace {

using reference::ModelRgb;
using reference::ModelXyz;

// Copper is not among the reference's materials.
std::complex<double> index_of(const std::string& metal, double nm) {
    if (metal == "cu") return shipped_material(metal)->at(nm);
    const auto index = reference::material_index(metal, nm);
    return {index.real(), index.imag()};
}

using IndexAt = std::function<std::complex<double>(double nm)>;

ModelXyz colour_at(const IndexAt& index, double cosine) {
    const auto& light = reference::ModelLight::of("D65", 2);
    reference::Triple seen{};
    for (std::size_t i = 0; i < light.weights().size(); ++i) {
        const std::complex<double> n = index(reference::light_begins_nm + static_cast<double>(i));
        const std::complex<double> inside = std::sqrt(n * n - (1.0 - cosine * cosine));  // n cos of the refracted ray
        const double s = std::norm((cosine - inside) / (cosine + inside));
        const double p = std::norm((n * n * cosine - inside) / (n * n * cosine + inside));
        const double share = i == 0 || i + 1 == light.weights().size() ? 0.5 : 1.0;
        for (std::size_t c = 0; c < 3; ++c) seen[c] += share * 0.5 * (s + p) * light.weights()[i][c];
    }
    return light.adapted(seen);
}

ModelXyz colour_at(const std::string& metal, double cosine) {
    return colour_at([&](double nm) { return index_of(metal, nm); }, cosine);
}

std::function<ModelXyz(const ModelRgb&)> xyz_from(const std::string& space) {
    if (space == "lin_rec709") return reference::from_rec709;
    if (space == "lin_p3d65") return reference::from_p3d65;
    EXPECT_EQ(space, "lin_ap1");
    return reference::from_acescg;
}

double cosine_of(int degree) {
    return degree == 90 ? 0.0 : std::cos(degree * std::numbers::pi / 180.0);
}

double error_of(const ModelXyz& one, const ModelXyz& other) {
    return reference::ciede2000(reference::lab_of(one), reference::lab_of(other));
}

TEST(MetalTable, HasEveryShippedMetalInThreeSpaces) {
    std::set<std::string> metals;
    for (const std::string& name : shipped_material_names()) {
        // What nacre ships is a metal if it absorbs within a wavelength all over the visible.
        const auto material = shipped_material(name);
        bool is_metal = true;
        for (double nm = 380.0; nm <= 780.0; nm += 10.0) is_metal = is_metal && material->at(nm).imag() > 1.0;
        if (is_metal) metals.insert(name);
    }
    const auto names = metal_names();
    EXPECT_EQ(metals, std::set<std::string>(names.begin(), names.end()));
    EXPECT_EQ(metal_table().size(), 3 * metals.size());
}

TEST(MetalTable, HasTheColoursOfFresnelsEquations) {
    for (const MetalInSpace& row : metal_table()) {
        const auto to_xyz = xyz_from(row.space);
        // The spaces' matrices are rounded to 15 digits, and those of the reference to six or more.
        EXPECT_LT(error_of(to_xyz(row.f0), colour_at(row.metal, 1.0)), 2e-3) << row.metal << " " << row.space;
        EXPECT_LT(error_of(to_xyz(row.f82), colour_at(row.metal, 1.0 / 7.0)), 2e-3) << row.metal << " " << row.space;
    }
}

// The model as OpenPBR writes it: b from the tint, F = S - b c (1 - c)^6.
TEST(MetalTable, HasTheErrorOfTheF82TintModel) {
    std::map<std::string, std::vector<ModelXyz>> truth;
    for (const std::string& metal : metal_names()) {
        for (int degree = 0; degree <= 90; ++degree) truth[metal].push_back(colour_at(metal, cosine_of(degree)));
    }
    for (const MetalInSpace& row : metal_table()) {
        const auto to_xyz = xyz_from(row.space);
        double f82 = 0.0, schlick = 0.0;
        for (int degree = 0; degree <= 90; ++degree) {
            const double c = cosine_of(degree);
            ModelRgb plain{}, model{};
            for (std::size_t i = 0; i < 3; ++i) {
                const double edge = row.f0[i] + (1 - row.f0[i]) * std::pow(6.0 / 7.0, 5);
                const double b = edge * (1 - row.tint[i]) / (1.0 / 7.0 * std::pow(6.0 / 7.0, 6));
                plain[i] = row.f0[i] + (1 - row.f0[i]) * std::pow(1 - c, 5);
                model[i] = plain[i] - b * c * std::pow(1 - c, 6);
            }
            const ModelXyz& metal = truth[row.metal][static_cast<std::size_t>(degree)];
            f82 = std::max(f82, error_of(to_xyz(model), metal));
            schlick = std::max(schlick, error_of(to_xyz(plain), metal));
        }
        EXPECT_NEAR(row.f82_de00, f82, 2e-3) << row.metal << " " << row.space;
        EXPECT_NEAR(row.schlick_de00, schlick, 2e-3) << row.metal << " " << row.space;
        EXPECT_LT(row.f82_de00, row.schlick_de00);
    }
}

// What configs/mechanisms.md says about the metal that nacre makes of F0 alone.
TEST(MetalTable, IsNearWhatAColouredMetalWithoutTintShows) {
    const std::map<std::string, double> said{{"ag", 1.4}, {"al", 2.4}, {"cu", 4.9}, {"cr", 7.0}, {"au", 7.3}};
    for (const MetalInSpace& row : metal_table()) {
        if (row.space != "lin_rec709") continue;
        MetalColour colour{row.f0, {}};
        for (double& component : colour.f0) component = std::min(component, most_f0);
        const auto made = coloured_metal(colour);
        double worst = 0.0;
        for (int degree = 0; degree <= 90; ++degree) {
            const double c = cosine_of(degree);
            const ModelXyz bare = colour_at([&](double nm) { return made->at(nm); }, c);
            worst = std::max(worst, error_of(bare, colour_at(row.metal, c)));
        }
        EXPECT_NEAR(worst, said.at(row.metal), 0.051) << row.metal;  // one decimal
    }
}

}  // namespace
}  // namespace nacre::test
