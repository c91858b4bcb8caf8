#include "nacre/pick/band/chromaticity_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nacre {
namespace {

// Cells of the (u', v') plane that the triangles are sorted into. The locus reaches to 0.63 and 0.6.
constexpr int buckets_per_side = 64;
constexpr double uv_side = 0.7;

// Barycentric coordinates may be as negative as this: triangles are only nearly where the colours between them are.
constexpr double slack = 0.15;
constexpr double most_outside = 4.0;

std::size_t bucket_index(double value) {
    return static_cast<std::size_t>(std::clamp(value / uv_side * buckets_per_side, 0.0, buckets_per_side - 1.0));
}

}  // namespace

ChromaticityTable::ChromaticityTable(std::size_t columns, std::size_t rows,
                                     const std::function<Xyz(const Place&)>& colour)
    : buckets_(buckets_per_side * buckets_per_side) {
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t j = 0; j < rows; ++j) {
            const Place place{static_cast<double>(i) / static_cast<double>(columns - 1),
                              static_cast<double>(j) / static_cast<double>(rows - 1)};
            places_.push_back(place);
            uvs_.push_back(uv_of(colour(place)));
        }
    }
    for (std::size_t i = 0; i + 1 < columns; ++i) {
        for (std::size_t j = 0; j + 1 < rows; ++j) {
            const std::size_t node = i * rows + j;
            add_triangle(node, node + 1, node + rows);
            add_triangle(node + 1, node + rows, node + rows + 1);
        }
    }
}

void ChromaticityTable::add_triangle(std::size_t a, std::size_t b, std::size_t c) {
    Uv low{1e9, 1e9};
    Uv high{-1e9, -1e9};
    for (const std::size_t corner : {a, b, c}) {
        const Uv& uv = uvs_[corner];
        if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) return;  // no light at all
        low = {std::min(low.u, uv.u), std::min(low.v, uv.v)};
        high = {std::max(high.u, uv.u), std::max(high.v, uv.v)};
    }
    const Uv margin{slack * (high.u - low.u), slack * (high.v - low.v)};
    const auto triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    for (std::size_t row = bucket_index(low.v - margin.v); row <= bucket_index(high.v + margin.v); ++row) {
        for (std::size_t column = bucket_index(low.u - margin.u); column <= bucket_index(high.u + margin.u); ++column)
            buckets_[row * buckets_per_side + column].push_back(triangle);
    }
}

// @param outside  receives how far the target is outside, in heights of the triangle
ChromaticityTable::Place ChromaticityTable::place_in(std::size_t triangle, Uv target, double& outside) const {
    const auto& [a, b, c] = triangles_[triangle];
    const double bu = uvs_[b].u - uvs_[a].u, bv = uvs_[b].v - uvs_[a].v;
    const double cu = uvs_[c].u - uvs_[a].u, cv = uvs_[c].v - uvs_[a].v;
    const double tu = target.u - uvs_[a].u, tv = target.v - uvs_[a].v;
    const double area = bu * cv - bv * cu;
    const double beta = (tu * cv - tv * cu) / area;
    const double gamma = (bu * tv - bv * tu) / area;
    outside = std::numeric_limits<double>::infinity();
    if (!std::isfinite(beta) || !std::isfinite(gamma)) return {};  // its corners lie on a line
    outside = std::max({-beta, -gamma, beta + gamma - 1.0});
    const Place &pa = places_[a], &pb = places_[b], &pc = places_[c];
    return {std::clamp(pa.p + beta * (pb.p - pa.p) + gamma * (pc.p - pa.p), 0.0, 1.0),
            std::clamp(pa.q + beta * (pb.q - pa.q) + gamma * (pc.q - pa.q), 0.0, 1.0)};
}

ChromaticityTable::Places ChromaticityTable::starts(Uv target) const {
    Places places;
    Place nearest;
    double least_outside = most_outside;
    for (const std::uint32_t triangle : buckets_[bucket_index(target.v) * buckets_per_side + bucket_index(target.u)]) {
        double outside = 0.0;
        const Place place = place_in(triangle, target, outside);
        if (outside <= slack && places.count < places.place.size()) places.place[places.count++] = place;
        if (!(outside < least_outside)) continue;
        least_outside = outside;
        nearest = place;
    }
    // Next to the locus triangles are thin, and it is their chords that they end at.
    if (places.count == 0 && least_outside < most_outside) places.place[places.count++] = nearest;
    return places;
}

}  // namespace nacre
