#include "nacre/swatch/lit_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
namespace {

constexpr int few_samples = 2;
constexpr int many_samples = 6;
// Between samples, relative to the brightest of them and something beside it, so that what is dark is not looked at
// closely: some grey, and a part of the brightest material, because that is what will be exposed. Chosen.
constexpr double visible_difference = 0.03;
constexpr double some_grey = 0.2;
constexpr double some_material = 0.1;

// The least and the largest luminance of some samples.
struct LuminanceRange {
    double least = 1e300, most = 0.0;
    void add(double luminance) {
        least = std::min(least, luminance);
        most = std::max(most, luminance);
    }
    bool is_visible(double beside) const { return most - least > visible_difference * (most + beside); }
};

struct Pixel {
    Seen mean;
    bool is_even = true;  // whether its samples hardly differ
};

// @param beside  the part of the brightest material
Pixel sampled(const std::function<Seen(double, double)>& look, int samples, double beside) {
    Pixel pixel;
    LuminanceRange material, rest;
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            const Seen seen = look((i + 0.5) / samples, (j + 0.5) / samples);
            pixel.mean.material = pixel.mean.material + seen.material;
            pixel.mean.rest = pixel.mean.rest + seen.rest;
            pixel.mean.is_grazing = pixel.mean.is_grazing || seen.is_grazing;
            material.add(seen.material.y);
            rest.add(seen.rest.y);
        }
    }
    const double share = 1.0 / (samples * samples);
    pixel.mean.material = share * pixel.mean.material;
    pixel.mean.rest = share * pixel.mean.rest;
    pixel.is_even = !material.is_visible(beside) && !rest.is_visible(some_grey);
    return pixel;
}

// Seen through a coarse grid.
double brightest_luminance(const Camera& camera, const std::function<Seen(const Ray&)>& look) {
    constexpr int steps = 60;
    double brightest = 0.0;
    for (int j = 0; j <= steps; ++j) {
        for (int i = 0; i <= steps; ++i) {
            const Seen seen = look(camera.through(2.0 * i / steps - 1.0, 2.0 * j / steps - 1.0));
            if (!seen.is_grazing) brightest = std::max(brightest, seen.material.y);
        }
    }
    return brightest;
}

double brightest_component(const Xyz& colour) {
    const Rgb rgb = linear_rec709(colour);
    return std::max({rgb.r, rgb.g, rgb.b});
}

}  // namespace

Camera camera_at(const glm::dvec3& from, const glm::dvec3& to, double half_side) {
    const glm::dvec3 forward = glm::normalize(to - from);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3{0.0, 1.0, 0.0}));
    return {from, forward, right, glm::cross(right, forward), half_side};
}

Ray Camera::through(double x, double y) const {
    return {from, glm::normalize(forward + half_side * (x * right + y * up))};
}

LitPicture take_picture(const Camera& camera, const std::function<Seen(const Ray&)>& look, int side) {
    LitPicture picture{Image<Xyz>(side, side), Image<Xyz>(side, side)};
    const double beside = some_material * brightest_luminance(camera, look);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const auto within = [&](double right, double down) {
                return look(camera.through(2.0 * (column + right) / side - 1.0, 1.0 - 2.0 * (row + down) / side));
            };
            Pixel pixel = sampled(within, few_samples, beside);
            if (!pixel.is_even) pixel = sampled(within, many_samples, beside);
            picture.material.at(column, row) = pixel.mean.material;
            picture.rest.at(column, row) = pixel.mean.rest;
            if (!pixel.mean.is_grazing)
                picture.brightest = std::max(picture.brightest, brightest_component(pixel.mean.material));
        }
    }
    return picture;
}

Image<Xyz> exposed(const LitPicture& picture, double exposure) {
    Image<Xyz> image = picture.rest;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) = exposure * picture.material.at(x, y) + image.at(x, y);
        }
    }
    return image;
}

}  // namespace nacre
