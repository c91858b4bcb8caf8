#include "nacre/swatch/lit_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

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

// @param look    at a point of the pixel, in [0, 1] to the right and down
// @param beside  the part of the brightest material
template <typename Look>
Pixel sampled(const Look& look, int samples, double beside) {
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

template <typename Look>
Seen sampled_pixel(const Look& look, double beside) {
    const Pixel few = sampled(look, few_samples, beside);
    return few.is_even ? few.mean : sampled(look, many_samples, beside).mean;
}

// ---- where a picture is smooth, cells of several pixels are interpolated between their corners, which neighbours
// share

constexpr int cell = 2;  // pixels along a side
// Of second differences between corners, relative to what is seen there. Chosen: pictures differ by at most one 8-bit
// code from those of which every pixel is sampled.
constexpr double visible_bend = 0.003;

using FourWeights = std::array<double, 4>;
using FourSeen = std::array<const Seen*, 4>;

// Lagrange's cubics for values at -1, 0, 1 and 2.
FourWeights cubic_at(double t) {
    return {-t * (t - 1.0) * (t - 2.0) / 6.0, 0.5 * (t + 1.0) * (t - 1.0) * (t - 2.0), -0.5 * (t + 1.0) * t * (t - 2.0),
            (t + 1.0) * t * (t - 1.0) / 6.0};
}

// The mean of few samples in a pixel of a cell.
FourWeights cubic_mean(int pixel) {
    FourWeights mean{};
    for (int i = 0; i < few_samples; ++i) {
        const FourWeights sample = cubic_at((pixel + (i + 0.5) / few_samples) / cell);
        for (std::size_t j = 0; j < mean.size(); ++j) mean[j] += sample[j] / few_samples;
    }
    return mean;
}

Seen mixed(const FourSeen& seen, const FourWeights& weights) {
    const auto mix = [&](const Xyz Seen::*part) {
        Xyz sum;
        for (std::size_t j = 0; j < seen.size(); ++j) sum = sum + weights[j] * seen[j]->*part;
        return sum;
    };
    return {mix(&Seen::material), mix(&Seen::rest), seen[1]->is_grazing};
}

// Whether cubics between the inner two are good. @param beside  as of LuminanceRange
bool are_smooth(const FourSeen& seen, double beside) {
    const auto bends_little = [&](const Xyz Seen::*part, double Xyz::*component, double beside_part) {
        const auto at = [&](std::size_t j) { return seen[j]->*part.*component; };
        const double bend = std::max(std::abs(at(0) - 2.0 * at(1) + at(2)), std::abs(at(1) - 2.0 * at(2) + at(3)));
        return bend <= visible_bend * (std::max(at(1), at(2)) + beside_part);
    };
    const auto bend_little = [&](const Xyz Seen::*part, double beside_part) {
        return bends_little(part, &Xyz::x, beside_part) && bends_little(part, &Xyz::y, beside_part) &&
               bends_little(part, &Xyz::z, beside_part);
    };
    return seen[1]->is_grazing == seen[2]->is_grazing && bend_little(&Seen::material, beside) &&
           bend_little(&Seen::rest, some_grey);
}

FourSeen four_of(const std::vector<Seen>& row, std::size_t first) {
    return {&row[first], &row[first + 1], &row[first + 2], &row[first + 3]};
}

// The means of pixels in smooth cells, row by row.
class Cells {
public:
    Cells(const Camera& camera, const std::function<Seen(const Ray&)>& look, int side, double beside)
        : camera_(camera), look_(look), side_(side), cells_((side + cell - 1) / cell), beside_(beside) {
        for (int pixel = 0; pixel < cell; ++pixel) weights_[static_cast<std::size_t>(pixel)] = cubic_mean(pixel);
        for (int corner = 0; corner < 3; ++corner) add_corners();
    }

    // The next row of cells: as many pixels wide as all cells, and `cell` high. Empty where it is not smooth.
    Image<std::optional<Seen>> next_row() {
        add_corners();
        std::array<std::vector<Seen>, cell> between;  // along the lines down from corners, at the rows of pixels
        std::vector<char> is_smooth;
        for (std::size_t i = 0; i < corners_[0].size(); ++i) {
            const FourSeen seen{&corners_[0][i], &corners_[1][i], &corners_[2][i], &corners_[3][i]};
            is_smooth.push_back(are_smooth(seen, beside_) ? 1 : 0);
            for (std::size_t row = 0; row < between.size(); ++row) between[row].push_back(mixed(seen, weights_[row]));
        }
        Image<std::optional<Seen>> means(cells_ * cell, cell);
        for (int i = 0; i < cells_; ++i) {
            const auto first = static_cast<std::size_t>(i);
            const bool all =
                std::all_of(is_smooth.begin() + i, is_smooth.begin() + i + 4, [](char c) { return c != 0; });
            if (all && std::all_of(between.begin(), between.end(),
                                   [&](const auto& row) { return are_smooth(four_of(row, first), beside_); }))
                fill(means, i, between);
        }
        return means;
    }

private:
    void fill(Image<std::optional<Seen>>& means, int i, const std::array<std::vector<Seen>, cell>& between) const {
        for (int row = 0; row < cell; ++row) {
            const FourSeen seen = four_of(between[static_cast<std::size_t>(row)], static_cast<std::size_t>(i));
            for (int column = 0; column < cell; ++column)
                means.at(i * cell + column, row) = mixed(seen, weights_[static_cast<std::size_t>(column)]);
        }
    }

    // Of the next row, and one more at either end.
    void add_corners() {
        std::rotate(corners_.begin(), corners_.begin() + 1, corners_.end());
        corners_.back().clear();
        const auto place = [&](int corner) { return 2.0 * corner * cell / side_ - 1.0; };
        for (int column = -1; column <= cells_ + 1; ++column)
            corners_.back().push_back(look_(camera_.through(place(column), -place(next_corners_))));
        ++next_corners_;
    }

    const Camera& camera_;
    const std::function<Seen(const Ray&)>& look_;
    int side_;
    int cells_;  // along a side
    double beside_;
    std::array<FourWeights, cell> weights_;
    std::array<std::vector<Seen>, 4> corners_;  // of four rows, the lowest last
    int next_corners_ = -1;
};

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

// The brightest pixel is always sampled, so that the exposure does not depend on how others were found.
bool may_be_brightest(const Xyz& material, double brightest) {
    constexpr double nearly = 0.999;
    return brightest_component(material) > nearly * brightest;
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
    Cells cells(camera, look, side, beside);
    Image<std::optional<Seen>> smooth;
    for (int row = 0; row < side; ++row) {
        if (row % cell == 0) smooth = cells.next_row();
        for (int column = 0; column < side; ++column) {
            const auto within = [&](double right, double down) {
                return look(camera.through(2.0 * (column + right) / side - 1.0, 1.0 - 2.0 * (row + down) / side));
            };
            const std::optional<Seen>& known = smooth.at(column, row % cell);
            const bool is_good = known && (known->is_grazing || !may_be_brightest(known->material, picture.brightest));
            const Seen mean = is_good ? *known : sampled_pixel(within, beside);
            picture.material.at(column, row) = mean.material;
            picture.rest.at(column, row) = mean.rest;
            if (!is_good && !mean.is_grazing)
                picture.brightest = std::max(picture.brightest, brightest_component(mean.material));
        }
    }
    return picture;
}

Image<Xyz> exposed(LitPicture picture, double exposure) {
    std::transform(picture.material.begin(), picture.material.end(), picture.rest.begin(), picture.rest.begin(),
                   [&](const Xyz& material, const Xyz& rest) { return exposure * material + rest; });
    return std::move(picture.rest);
}

}  // namespace nacre
