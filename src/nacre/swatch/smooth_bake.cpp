#include "nacre/swatch/smooth_bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

// Chosen on the shipped scenes for the fewest colours.
constexpr std::size_t node_count = 15;
constexpr int widest_part = 104;
constexpr int narrowest_part = 40;  // a narrower one would need about as many colours as it has
// A part is tried behind these nodes, in the middle between two.
constexpr std::array<std::size_t, 5> tried_behind{1, 4, 7, 10, 13};

// What an interpolated colour may be off, relative to its luminance and something that no display shows. Errors of 3e-5
// are up to 0.2 codes of sRGB where a component is near 0, and up to 0.03 in most colours.
constexpr double along_one_row = 1e-6;  // costs little
constexpr double along_rows = 1e-5;
constexpr double between_rows = 3e-5;  // larger, because errors along the rows add to it
constexpr double unseen = 1e-3;

// The numbers of some lines, and the polynomial through them.
struct Part {
    std::array<int, node_count> nodes;  // ascending
    std::array<double, node_count> scale;
};
using Weights = std::array<double, node_count>;

// The nodes are the extrema of a Chebyshev polynomial, rounded: the ends are among them, and neighbours share those.
// @pre to - from >= narrowest_part, so that no two are equal
Part part_between(int from, int to) {
    Part part;
    for (std::size_t j = 0; j < node_count; ++j) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(j) / (node_count - 1));
        part.nodes[j] = from + static_cast<int>(std::lround(share * (to - from)));
    }
    for (std::size_t j = 0; j < node_count; ++j) {
        double product = 1.0;
        for (std::size_t i = 0; i < node_count; ++i) {
            if (i != j) product *= part.nodes[j] - part.nodes[i];
        }
        part.scale[j] = 1.0 / product;
    }
    return part;
}

// Of Lagrange's polynomials, in their barycentric form. @pre the place is no node
Weights weights_at(const Part& part, int place) {
    double product = 1.0;
    for (const int node : part.nodes) product *= place - node;
    Weights weights;
    for (std::size_t j = 0; j < node_count; ++j) weights[j] = product * part.scale[j] / (place - part.nodes[j]);
    return weights;
}

bool agree(const Xyz& guess, const Xyz& colour, double tolerance) {
    const double allowed = tolerance * (colour.y + unseen);
    return std::abs(guess.x - colour.x) <= allowed && std::abs(guess.y - colour.y) <= allowed &&
           std::abs(guess.z - colour.z) <= allowed;
}

// Lines of equal length, one after another: the pixels of a row, or the rows of a picture.
class Lines {
public:
    Lines(std::span<Xyz> colours, int count)
        : colours_(colours), length_(colours.size() / static_cast<std::size_t>(count)), guess_(length_) {}

    void interpolate(const Part& part, int place) { interpolate(part, place, line(place)); }

    // Whether a line that is computed lies on the polynomial.
    bool is_on(const Part& part, int place, double tolerance) {
        interpolate(part, place, guess_);
        return std::equal(guess_.begin(), guess_.end(), line(place).begin(),
                          [&](const Xyz& guess, const Xyz& colour) { return agree(guess, colour, tolerance); });
    }

private:
    std::span<Xyz> line(int i) const { return colours_.subspan(static_cast<std::size_t>(i) * length_, length_); }

    void interpolate(const Part& part, int place, std::span<Xyz> result) const {
        const Weights weights = weights_at(part, place);
        std::fill(result.begin(), result.end(), Xyz{});
        for (std::size_t j = 0; j < node_count; ++j) {
            const std::span<const Xyz> node = line(part.nodes[j]);
            for (std::size_t k = 0; k < length_; ++k) {
                result[k].x += weights[j] * node[k].x;
                result[k].y += weights[j] * node[k].y;
                result[k].z += weights[j] * node[k].z;
            }
        }
    }

    std::span<Xyz> colours_;
    std::size_t length_;
    std::vector<Xyz> guess_;
};

// Where the first parts end, the last one first.
std::vector<int> first_ends(int count) {
    const int last = count - 1;
    const int parts = std::max(1, (last + widest_part - 1) / widest_part);
    std::vector<int> ends;
    for (int part = parts; part > 0; --part) ends.push_back(last * part / parts);
    return ends;
}

// @param compute  fills the line of a number
template <typename Compute>
void fill_lines(std::span<Xyz> colours, int count, double tolerance, const Compute& compute) {
    Lines lines(colours, count);
    std::vector<char> is_computed(static_cast<std::size_t>(count), 0);
    const auto need = [&](int i) {
        char& is_there = is_computed[static_cast<std::size_t>(i)];
        if (is_there == 0) compute(i);
        is_there = 1;
    };
    const auto is_smooth = [&](const Part& part) {
        std::for_each(part.nodes.begin(), part.nodes.end(), need);
        return std::all_of(tried_behind.begin(), tried_behind.end(), [&](std::size_t j) {
            const int place = (part.nodes[j] + part.nodes[j + 1]) / 2;
            need(place);
            return place == part.nodes[j] || lines.is_on(part, place, tolerance);
        });
    };
    std::vector<int> ends = first_ends(count);
    for (int from = 0; !ends.empty();) {
        const int to = ends.back();
        if (to - from < narrowest_part) {
            for (int i = from; i <= to; ++i) need(i);
        } else {
            const Part part = part_between(from, to);
            if (!is_smooth(part)) {
                ends.push_back((from + to) / 2);
                continue;
            }
            for (int i = from; i <= to; ++i) {
                if (is_computed[static_cast<std::size_t>(i)] == 0) lines.interpolate(part, i);
            }
        }
        from = to;
        ends.pop_back();
    }
}

}  // namespace

Image<Xyz> bake_smoothly(const Job& job) {
    Image<Xyz> image(job.width, job.height);
    Sampler sampler(job);
    const auto width = static_cast<std::size_t>(job.width);
    const double tolerance = job.height == 1 ? along_one_row : along_rows;
    const auto fill_row = [&](int row) {
        const double y = coordinate_of_texel(row, job.height);
        const std::span<Xyz> pixels(&image.at(0, row), width);
        fill_lines(pixels, job.width, tolerance, [&](int column) {
            pixels[static_cast<std::size_t>(column)] = sampler.at(coordinate_of_texel(column, job.width), y);
        });
    };
    fill_lines({image.data(), image.size()}, job.height, between_rows, fill_row);
    return image;
}

}  // namespace nacre
