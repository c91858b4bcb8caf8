#include "nacre/optics/crystal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "nacre/optics/refractive_index.h"

namespace nacre {
namespace {

// Planes on either side of one at 0 whose spheres may reach into the half period around it.
int neighbours(double radius_nm, double spacing_nm) {
    return static_cast<int>(std::ceil(radius_nm / spacing_nm + 0.5));
}

// The circles that the plane at height z cuts out of spheres, over the area of a sphere's cell; above 1 where spheres
// overlap. Within a plane they touch: a hexagonal lattice, a cell of sqrt(3) / 2 diameters squared.
// @param z_nm  at most half a period from 0
double circles_share(const Crystal& crystal, double z_nm) {
    const double radius_nm = 0.5 * crystal.diameter_nm;
    const double spacing_nm = plane_spacing_nm(crystal);
    double squares = 0.0;
    for (int plane = -neighbours(radius_nm, spacing_nm); plane <= neighbours(radius_nm, spacing_nm); ++plane) {
        const double distance_nm = std::abs(z_nm - plane * spacing_nm);
        if (distance_nm < radius_nm) squares += (radius_nm - distance_nm) * (radius_nm + distance_nm);
    }
    return std::numbers::pi * squares / (0.5 * std::numbers::sqrt3 * crystal.diameter_nm * crystal.diameter_nm);
}

// A parabola over [0, 1].
struct Parabola {
    double left, middle, right;

    double at(double t) const {
        return left * (1.0 - t) * (1.0 - 2.0 * t) + middle * 4.0 * t * (1.0 - t) + right * t * (2.0 * t - 1.0);
    }
    // Simpson's rule, which is exact.
    double integral(double from, double to) const {
        return (to - from) / 6.0 * (at(from) + 4.0 * at(0.5 * (from + to)) + at(to));
    }
    // 0, what zeros there are between, and 1.
    std::vector<double> pieces() const {
        const double a = 2.0 * (left + right) - 4.0 * middle;
        const double b = 4.0 * middle - 3.0 * left - right;
        std::vector<double> ends{0.0, 1.0};
        const double root = std::sqrt(std::max(b * b - 4.0 * a * left, 0.0));
        const double sum = -0.5 * (b + std::copysign(root, b));
        for (const double zero : {sum / a, left / sum}) {
            if (zero > 0.0 && zero < 1.0) ends.push_back(zero);  // neither infinities nor 0 / 0
        }
        std::sort(ends.begin(), ends.end());
        return ends;
    }
};

// The mean of what is below 0 of a parabola, and of 0 instead of what is above.
double mean_below(const Parabola& parabola) {
    double sum = 0.0;
    const std::vector<double> ends = parabola.pieces();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        if (parabola.at(0.5 * (ends[i] + ends[i + 1])) < 0.0) sum += parabola.integral(ends[i], ends[i + 1]);
    }
    return sum;
}

// The mean of sphere_share() between two heights. Where a plane's spheres begin and end parabolas meet, and each is
// integrated exactly, so that slices hold as much as the period whatever their number.
// @param from_nm, to_nm  from < to, at most half a period from 0
double mean_share(const Crystal& crystal, double from_nm, double to_nm) {
    const double radius_nm = 0.5 * crystal.diameter_nm;
    const double spacing_nm = plane_spacing_nm(crystal);
    std::vector<double> ends_nm{from_nm, to_nm};
    for (int plane = -neighbours(radius_nm, spacing_nm); plane <= neighbours(radius_nm, spacing_nm); ++plane) {
        for (const double side_nm : {-radius_nm, radius_nm}) {
            const double end_nm = plane * spacing_nm + side_nm;
            if (end_nm > from_nm && end_nm < to_nm) ends_nm.push_back(end_nm);
        }
    }
    std::sort(ends_nm.begin(), ends_nm.end());
    double missing_nm = 0.0;
    for (std::size_t i = 0; i + 1 < ends_nm.size(); ++i) {
        const double left_nm = ends_nm[i], right_nm = ends_nm[i + 1];
        const auto excess = [&](double z_nm) { return circles_share(crystal, z_nm) - 1.0; };
        missing_nm +=
            (right_nm - left_nm) * mean_below({excess(left_nm), excess(0.5 * (left_nm + right_nm)), excess(right_nm)});
    }
    return std::clamp(1.0 + missing_nm / (to_nm - from_nm), 0.0, 1.0);
}

}  // namespace

double plane_spacing_nm(const Crystal& crystal) {
    return crystal.spacing_nm > 0.0 ? crystal.spacing_nm : std::sqrt(2.0 / 3.0) * crystal.diameter_nm;
}

double sphere_share(const Crystal& crystal, double z_nm) {
    const double spacing_nm = plane_spacing_nm(crystal);
    return std::min(circles_share(crystal, z_nm - spacing_nm * std::round(z_nm / spacing_nm)), 1.0);
}

RefractiveIndex effective_index(const Crystal& crystal, double wavelength_nm) {
    const double half_nm = 0.5 * plane_spacing_nm(crystal);
    const double share = mean_share(crystal, -half_nm, half_nm);
    const RefractiveIndex medium = crystal.medium.at(wavelength_nm);
    const RefractiveIndex sphere = crystal.sphere.at(wavelength_nm);
    // The principal root: k >= 0.
    return std::sqrt((1.0 - share) * (medium * medium) + share * (sphere * sphere));
}

// A period begins and ends half-way between planes of centres, so that it is the same from either side.
LayerSystem layer_system(const Crystal& crystal, int slices) {
    assert(crystal.diameter_nm > 0.0 && crystal.planes >= 1 && slices >= 4 && slices % 4 == 0);
    const double spacing_nm = plane_spacing_nm(crystal);
    std::vector<double> shares;
    for (int i = 0; i < slices / 2; i += 2) {
        const double from_nm = spacing_nm * (static_cast<double>(i) / slices - 0.5);
        const double step_nm = spacing_nm / slices;
        const double first = mean_share(crystal, from_nm, from_nm + step_nm);
        const double second = mean_share(crystal, from_nm + step_nm, from_nm + 2.0 * step_nm);
        const double mean = 0.5 * (first + second);
        // A slope's first moment is 4/3 of that of the steps which have its means (see crystal.h).
        const double room = std::min(mean, 1.0 - mean);
        const double off = std::clamp(4.0 / 3.0 * 0.5 * (second - first), -room, room);
        shares.insert(shares.end(), {mean - off, mean + off});
    }
    // The upper half's shares for the lower too: to the bit, so that the media are the same.
    for (std::size_t i = shares.size(); i-- > 0;) shares.push_back(shares[i]);
    LayerSystemBuilder builder(crystal.incident, crystal.substrate);
    builder.begin_group(crystal.planes);
    for (const double share : shares)
        builder.graded_layer(crystal.medium, crystal.sphere, share, spacing_nm / slices, Mixing::permittivity);
    builder.end_group();
    return builder.take();
}

}  // namespace nacre
