#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// What a renderer needs to show a shipped metal, in one linear RGB space, and how near it comes to the metal.
///
/// F82 is the reflectance at cos(theta) = 1/7, about 82 degrees. The F82-tint model has Schlick's approximation
/// S(c) = F0 + (1 - F0) (1 - c)^5, less b c (1 - c)^6, where b is such that F82 is met; the tint is F82 / S(1/7), which
/// OpenPBR calls specular_color.
/// Source: Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material; OpenPBR Surface 1.1, section
/// "Metal". All colours are those under D65, seen by the CIE 1931 observer.
struct MetalInSpace {
    std::string metal;        ///< "au"
    std::string description;  ///< "gold"
    std::string space;        ///< "lin_rec709"
    std::array<double, 3> f0{};
    std::array<double, 3> f82{};
    std::array<double, 3> tint{};
    double f82_de00 = 0.0;      ///< the largest CIEDE2000 of the model at whole degrees from 0 to 90
    double schlick_de00 = 0.0;  ///< the same of Schlick's approximation alone
};

/// The metals among the shipped materials.
std::vector<std::string> metal_names();

/// Every metal in linear Rec.709, linear P3 with D65, and ACEScg; by metal, in this order.
std::vector<MetalInSpace> metal_table();

}  // namespace nacre
