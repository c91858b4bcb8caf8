// The smooth reflectance of an RGB colour.
//
// The reflectance is a sigmoid of a quadratic in the wavelength (Jakob and Hanika 2019): three coefficients for three
// components. They are found by Levenberg and Marquardt's method. It starts from the grey of the same luminance, whose
// coefficients are known, and goes to the colour in even steps, each of which starts from the one before it: from grey
// straight to a nearly pure colour the method would get stuck where the sigmoid is flat.
#include "nacre/pick/smooth_rgb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {
namespace {

// Colours of sigmoids, as linear Rec.709. Coefficients here are of u^2, u, 1 with u in [-1, 1] over the wavelengths:
// nearly orthogonal, where those of t in [0, 1] are nearly dependent.
class SigmoidColours {
public:
    SigmoidColours() {
        const TristimulusWeights weights = make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("D65"));
        const GridWeights per_nm = make_grid_weights(weights, WavelengthGrid{});
        const glm::dmat3 to_rgb = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
        const glm::dmat3 seen = to_rgb * adaptation_matrix(Adaptation::bradford, per_nm.white, d65_white);
        for (std::size_t i = 0; i < per_nm.x.size(); ++i)
            weight_.push_back(seen * glm::dvec3(per_nm.x[i], per_nm.y[i], per_nm.z[i]));
        to_xyz_ = glm::inverse(to_rgb);
    }

    // The colour, and its derivatives by the coefficients, if wanted: column by coefficient.
    glm::dvec3 at(const glm::dvec3& coefficients, glm::dmat3* derivatives = nullptr) const {
        glm::dvec3 sum(0.0);
        if (derivatives != nullptr) *derivatives = glm::dmat3(0.0);
        const double last = static_cast<double>(weight_.size() - 1);
        for (std::size_t i = 0; i < weight_.size(); ++i) {
            const double u = 2.0 * static_cast<double>(i) / last - 1.0;
            const double x = (coefficients[0] * u + coefficients[1]) * u + coefficients[2];
            const double root = std::sqrt(1.0 + x * x);
            sum += (0.5 + 0.5 * x / root) * weight_[i];
            if (derivatives == nullptr) continue;
            const glm::dvec3 by_x = 0.5 / (root * root * root) * weight_[i];
            *derivatives += glm::dmat3(u * u * by_x, u * by_x, by_x);
        }
        return sum;
    }

    Lab lab(const glm::dvec3& rgb) const {
        const glm::dvec3 xyz = to_xyz_ * rgb;
        return to_lab({xyz.x, xyz.y, xyz.z}, d65_white);
    }

    double luminance(const glm::dvec3& rgb) const { return (to_xyz_ * rgb).y; }

private:
    std::vector<glm::dvec3> weight_;  // per nanometre
    glm::dmat3 to_xyz_{1.0};
};

// The x at which the sigmoid is a given reflectance. Its ends are infinitely far: at 1e9 it is 0 or 1 in double.
double sigmoid_argument(double reflectance) {
    constexpr double far = 1e9;
    const double root = std::sqrt(reflectance * (1.0 - reflectance));
    return root > 0.0 ? std::clamp((reflectance - 0.5) / root, -far, far) : std::copysign(far, reflectance - 0.5);
}

// Levenberg and Marquardt's method towards a colour, from coefficients that are near.
glm::dvec3 approach(const SigmoidColours& colours, const glm::dvec3& target, glm::dvec3 coefficients, int steps) {
    constexpr double close = 1e-13;  // a thousand roundings of a double
    double damping = 1e-6;
    glm::dmat3 derivatives;
    glm::dvec3 error = colours.at(coefficients, &derivatives) - target;
    for (int i = 0; i < steps && glm::dot(error, error) > close * close * glm::dot(target, target); ++i) {
        const glm::dmat3 transposed = glm::transpose(derivatives);
        glm::dmat3 normal = transposed * derivatives;
        for (int j = 0; j < 3; ++j) normal[j][j] *= 1.0 + damping;
        const double determinant = glm::determinant(normal);
        if (!(std::abs(determinant) > 0.0)) break;
        const glm::dvec3 moved = coefficients - glm::inverse(normal) * (transposed * error);
        glm::dmat3 derivatives_there;
        const glm::dvec3 error_there = colours.at(moved, &derivatives_there) - target;
        if (glm::dot(error_there, error_there) < glm::dot(error, error)) {
            coefficients = moved;
            error = error_there;
            derivatives = derivatives_there;
            damping = std::max(0.1 * damping, 1e-15);
        } else {
            damping *= 10.0;
            if (damping > 1e12) break;
        }
    }
    return coefficients;
}

}  // namespace

Upsampled upsampled(const std::array<double, 3>& rgb, int stations) {
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return {{rgb, {0.0, 0.0, sigmoid_argument(rgb[0])}}, 0.0};
    const SigmoidColours colours;
    const glm::dvec3 target(rgb[0], rgb[1], rgb[2]);
    const glm::dvec3 grey(std::clamp(colours.luminance(target), 1e-9, 1.0 - 1e-9));
    glm::dvec3 found(0.0, 0.0, sigmoid_argument(grey.x));
    // Empirical: with 20 000 random colours and all faces and corners of the cube every approach ended before its
    // limit.
    constexpr int steps_between = 20;
    constexpr int last_steps = 400;
    for (int i = 1; i < stations; ++i)
        found = approach(colours, grey + static_cast<double>(i) / stations * (target - grey), found, steps_between);
    found = approach(colours, target, found, last_steps);
    // u = 2 t - 1
    const std::array<double, 3> of_t{4.0 * found[0], 2.0 * found[1] - 4.0 * found[0], found[0] - found[1] + found[2]};
    return {{rgb, of_t}, ciede2000(colours.lab(colours.at(found)), colours.lab(target))};
}

}  // namespace nacre
