#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/layers.h"
#include "reference/materials.h"

namespace nacre::reference {

double spacing_of_planes_nm(const Crystal& crystal) {
    return crystal.spacing_nm > 0.0 ? crystal.spacing_nm : std::sqrt(2.0 / 3.0) * crystal.diameter_nm;
}

// Cells of two spheres' height: circles that spheres of this and the next planes leave at a height, of a hexagonal
// lattice; permittivities in proportion.
std::vector<Complex> plane_indices(const Crystal& crystal, int slices, double nm) {
    constexpr int samples = 16;
    const double spacing = spacing_of_planes_nm(crystal);
    const double radius = 0.5 * crystal.diameter_nm, cell = 2.0 * std::sqrt(3.0) * square(radius);
    const Complex holes = times(index_at(crystal.medium, nm), index_at(crystal.medium, nm));
    const Complex balls = times(index_at(crystal.sphere, nm), index_at(crystal.sphere, nm));
    std::vector<Complex> indices;
    for (int slice = 0; slice < slices; ++slice) {
        double share = 0.0;
        for (int sample = 0; sample < samples; ++sample) {
            const double z = spacing * ((slice + (sample + 0.5) / samples) / slices - 0.5);
            double area = 0.0;
            for (int plane = -4; plane <= 4; ++plane)
                area += std::max(0.0, std::numbers::pi * (square(radius) - square(z - plane * spacing)));
            share += std::min(area / cell, 1.0) / samples;
        }
        indices.push_back(std::sqrt(holes + share * (balls - holes)));
    }
    return indices;
}

Port crystal_port(const PlainLayers& layers, double nm, const std::vector<Complex>& indices, const Seen& from,
                  const Seen& to, const Wave& wave) {
    const Crystal& crystal = *layers.crystal;
    const double slice_nm = layers.stretch * spacing_of_planes_nm(crystal) / static_cast<double>(indices.size());
    std::vector<Seen> slices;
    for (const Complex& n : indices) slices.push_back(seen_in(n, wave));
    Port last = passage(slices[0].q, slice_nm, nm);
    for (std::size_t i = 1; i < slices.size(); ++i) {
        last = joined(last, face(slices[i - 1].admittance, slices[i].admittance));
        last = joined(last, passage(slices[i].q, slice_nm, nm));
    }
    Port power = joined(last, face(slices.back().admittance, slices.front().admittance));  // a period, to the next
    Port all = face(from.admittance, slices.front().admittance);
    for (int left = crystal.planes - 1; left > 0; left /= 2) {
        if (left % 2 == 1) all = joined(all, power);
        power = joined(power, power);
    }
    return joined(joined(all, last), face(slices.back().admittance, to.admittance));
}

}  // namespace nacre::reference
