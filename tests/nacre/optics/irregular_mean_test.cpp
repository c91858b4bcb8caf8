#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/irregular.h"
#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

using Complex = std::complex<double>;
using Colour = std::array<double, 3>;

LayerSystem morpho(int repeat) {
    LayerSystemBuilder builder(1.0, 1.0);
    builder.begin_group(repeat);
    builder.layer(RefractiveIndex(1.56, 0.06), 94.0);
    builder.layer(1.0, 83.0);
    builder.end_group();
    return builder.take();
}

// Means of a spectrum with broad weights, as an eye takes them.
template <class Spectrum>
Colour colour_of(const Spectrum& reflectance) {
    constexpr std::array<std::array<double, 2>, 3> peaks_and_widths{{{450.0, 40.0}, {550.0, 50.0}, {600.0, 50.0}}};
    Colour colour{};
    Colour total{};
    for (double nm = 400.0; nm <= 700.0; nm += 15.0) {
        const double value = reflectance(nm);
        for (std::size_t i = 0; i < 3; ++i) {
            const double from_peak = (nm - peaks_and_widths[i][0]) / peaks_and_widths[i][1];
            const double weight = std::exp(-0.5 * from_peak * from_peak);
            colour[i] += weight * value;
            total[i] += weight;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) colour[i] /= total[i];
    return colour;
}

Colour irregular_colour(const LayerSystem& regular, double spread_nm, int count, double theta_deg) {
    const LayerEnsemble ensemble = irregular_systems(regular, spread_nm, count);
    return colour_of([&](double nm) {
        double sum = 0.0;
        for (std::size_t i = 0; i < ensemble.systems.size(); ++i)
            sum += ensemble.shares[i] *
                   multilayer_response(ensemble.systems[i], Incidence::from_degrees(theta_deg), nm).reflectance();
        return sum;
    });
}

double largest_difference(const Colour& left, const Colour& right) {
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(left[i] - right[i]));
    return largest;
}

// Points and weights of Gauss and Hermite, for a normal variable of variance 1 (Numerical Recipes, section 4.6:
// Newton's method on orthonormal Hermite polynomials; starts here are taken from a fine grid of sign changes).
struct Node {
    double at;
    double weight;
};
std::vector<Node> gauss_hermite(int count) {
    double below = 0.0;  // the polynomial before the last
    const auto polynomial = [&](double x) {
        double last = 1.0;
        below = 0.0;
        for (int degree = 1; degree <= count; ++degree) {
            const double next = (x * last - std::sqrt(degree - 1.0) * below) / std::sqrt(degree);
            below = last;
            last = next;
        }
        return last;
    };
    std::vector<Node> nodes;
    constexpr double step = 1e-2;
    const double end = 2.0 * std::sqrt(count) + 1.0;
    for (double x = -end - step / 3.0; x < end; x += step) {
        if (polynomial(x) * polynomial(x + step) > 0.0) continue;
        double left = x;
        double right = x + step;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (left + right);
            (polynomial(left) * polynomial(middle) > 0.0 ? left : right) = middle;
        }
        polynomial(left);
        nodes.push_back({left, 1.0 / (count * below * below)});
    }
    return nodes;
}

// The mean over all thicknesses, one after the other. @pre no groups
Colour tensor_colour(LayerSystem& system, std::size_t layer, double spread_nm, const std::vector<Node>& nodes,
                     double theta_deg) {
    if (layer == system.nodes.size()) {
        return colour_of([&](double nm) {
            return multilayer_response(system, Incidence::from_degrees(theta_deg), nm).reflectance();
        });
    }
    const double nominal_nm = system.nodes[layer].thickness_nm;
    Colour mean{};
    for (const Node& node : nodes) {
        system.nodes[layer].thickness_nm = nominal_nm + spread_nm * node.at;
        const Colour colour = tensor_colour(system, layer + 1, spread_nm, nodes, theta_deg);
        for (std::size_t i = 0; i < 3; ++i) mean[i] += node.weight * colour[i];
    }
    system.nodes[layer].thickness_nm = nominal_nm;
    return mean;
}

// Exact mean reflectance of alternating layers between air, at normal incidence: moments E[r^p conj(r)^q] of the
// reflection coefficient, face by face from below. A face turns r into (rho + r) / (1 + rho r), whose powers are series
// in r; a layer multiplies r by a phase whose mean powers are known for a normal thickness. Cut off at `orders`.
double mean_reflectance(int repeat, const std::array<Complex, 2>& indices, const std::array<double, 2>& nominal_nm,
                        double spread_nm, double wavelength_nm, std::size_t orders) {
    using Matrix = std::vector<std::vector<Complex>>;
    const Matrix zero(orders, std::vector<Complex>(orders));
    Matrix moments = zero;
    moments[0][0] = 1.0;
    const auto face = [&](Complex above, Complex below) {
        const Complex rho = (above - below) / (above + below);
        Matrix powers = zero;  // of (rho + r) / (1 + rho r), by powers of r
        powers[0][0] = 1.0;
        for (std::size_t p = 1; p < orders; ++p) {
            for (std::size_t k = 0; k < orders; ++k) {
                powers[p][k] = rho * powers[p - 1][k];
                if (k > 0) powers[p][k] += powers[p - 1][k - 1] - rho * powers[p][k - 1];
            }
        }
        Matrix half = zero;
        Matrix whole = zero;
        for (std::size_t p = 0; p < orders; ++p)
            for (std::size_t k = 0; k < orders; ++k)
                for (std::size_t q = 0; q < orders; ++q) half[p][q] += powers[p][k] * moments[k][q];
        for (std::size_t p = 0; p < orders; ++p)
            for (std::size_t q = 0; q < orders; ++q)
                for (std::size_t k = 0; k < orders; ++k) whole[p][q] += half[p][k] * std::conj(powers[q][k]);
        moments = whole;
    };
    const auto layer = [&](Complex index, double nominal) {
        const Complex per_nm = 4.0 * std::numbers::pi / wavelength_nm * index;
        for (std::size_t p = 0; p < orders; ++p) {
            for (std::size_t q = 0; q < orders; ++q) {
                const Complex rate = static_cast<double>(p) * per_nm - static_cast<double>(q) * std::conj(per_nm);
                moments[p][q] *=
                    std::exp(Complex(0.0, 1.0) * rate * nominal - 0.5 * rate * rate * spread_nm * spread_nm);
            }
        }
    };
    face(indices[1], 1.0);
    for (int i = repeat - 1; i >= 0; --i) {
        layer(indices[1], nominal_nm[1]);
        face(indices[0], indices[1]);
        layer(indices[0], nominal_nm[0]);
        face(i == 0 ? Complex(1.0) : indices[1], indices[0]);
    }
    return moments[1][1].real();
}

TEST(IrregularMean, TendsToTheTensorQuadratureOfTwoAndThreeLayers) {
    const std::vector<Node> nodes = gauss_hermite(12);
    for (const double theta_deg : {0.0, 75.0}) {
        for (const int layers : {2, 3}) {
            LayerSystemBuilder builder(1.0, 1.5);
            builder.layer(1.83, 130.0);
            builder.layer(1.33, 150.0);
            if (layers == 3) builder.layer(1.83, 110.0);
            LayerSystem regular = builder.take();
            const Colour exact = tensor_colour(regular, 0, 10.0, nodes, theta_deg);
            const auto error = [&](int count) {
                return largest_difference(irregular_colour(regular, 10.0, count, theta_deg), exact);
            };
            EXPECT_LT(error(32), 1e-3) << theta_deg << " " << layers;
            EXPECT_LT(error(256), 1e-4) << theta_deg << " " << layers;
            EXPECT_LT(error(2048), 5e-5) << theta_deg << " " << layers;
        }
    }
}

TEST(IrregularMean, TendsToTheExactMeanOfTwentyLayers) {
    const LayerSystem regular = morpho(10);
    const auto exact = [](double spread_nm, std::size_t orders) {
        return colour_of([&](double nm) {
            const std::array<Complex, 2> indices{Complex(1.56, 0.06), Complex(1.0)};
            return mean_reflectance(10, indices, {94.0, 83.0}, spread_nm, nm, orders);
        });
    };
    const auto error = [&](double spread_nm, int count) {
        return largest_difference(irregular_colour(regular, spread_nm, count, 0.0), exact(spread_nm, 12));
    };
    // The moments by themselves: those of a regular stack, and where they are cut off.
    EXPECT_LT(largest_difference(irregular_colour(regular, 0.0, 2, 0.0), exact(0.0, 32)), 1e-5);
    EXPECT_LT(largest_difference(exact(5.0, 18), exact(5.0, 12)), 1e-5);
    EXPECT_LT(error(5.0, 64), 3e-4);
    EXPECT_LT(error(10.0, 64), 3e-3);
    EXPECT_LT(error(10.0, 512), 5e-4);
    EXPECT_LT(error(16.0, 512), 2e-3);
}

}  // namespace
}  // namespace nacre
