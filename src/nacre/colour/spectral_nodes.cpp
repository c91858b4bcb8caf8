#include "nacre/colour/spectral_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/base/spectrum.h"

namespace nacre {
namespace {

// Gauss-Legendre with four nodes on [-1, 1] (Abramowitz & Stegun, table 25.4).
struct QuadratureNode {
    double at;
    double share;
};
constexpr std::array<QuadratureNode, 4> quadrature{{{-0.861136311594052575, 0.347854845137453857},
                                                    {-0.339981043584856265, 0.652145154862546143},
                                                    {0.339981043584856265, 0.652145154862546143},
                                                    {0.861136311594052575, 0.347854845137453857}}};

// An interval of the wavenumber, in 1 / nm.
struct Panel {
    double from;
    double to;

    double wavenumber(double x) const { return 0.5 * ((from + to) + x * (to - from)); }
    double x(double wavenumber) const { return std::clamp((2.0 * wavenumber - (from + to)) / (to - from), -1.0, 1.0); }
};

double weight_at(const std::vector<double>& weights, std::size_t cell, double along) {
    return std::lerp(weights[cell], weights[cell + 1], along);
}

// Integrals over wavelength of the weights times the Chebyshev polynomials of x, degrees 0 to count - 1.
class Moments {
public:
    Moments(const TristimulusWeights& weights, const Panel& panel, int count)
        : weights_(weights), panel_(panel), x_(static_cast<std::size_t>(count)), y_(x_), z_(x_) {
        const double shortest_nm = 1.0 / panel.to;
        const double longest_nm = 1.0 / panel.from;
        const double per_nm = weights.cells_per_nm;
        for (double left = std::max(shortest_nm, static_cast<double>(weights.first_nm)); left < longest_nm;) {
            const double right = std::min((std::floor(left * per_nm + 1e-9) + 1.0) / per_nm, longest_nm);
            add_cell(left, right);
            left = right;
        }
    }

    const std::vector<double>& x() const { return x_; }
    const std::vector<double>& y() const { return y_; }
    const std::vector<double>& z() const { return z_; }

private:
    // Within one cell the weights are linear. The polynomials are cos(n phi) with x = cos(phi), whose phase must not
    // run far between the nodes of the quadrature.
    void add_cell(double left, double right) {
        const double phi_left = std::acos(panel_.x(1.0 / left));
        const double phi_right = std::acos(panel_.x(1.0 / right));
        constexpr double longest_phase = 1.5;
        const double phase = std::abs(phi_right - phi_left) * static_cast<double>(x_.size());
        const int parts = std::max(1, static_cast<int>(std::ceil(phase / longest_phase)));
        const double from_first_nm = std::max(0.5 * (left + right) - weights_.first_nm, 0.0);
        const auto cell = std::min(static_cast<std::size_t>(from_first_nm * weights_.cells_per_nm),
                                   static_cast<std::size_t>(weights_.count()) - 2);
        const double step = (phi_right - phi_left) / parts;
        for (int part = 0; part < parts; ++part) {
            Points points;
            for (std::size_t i = 0; i < quadrature.size(); ++i) {
                const double phi = phi_left + (part + 0.5 + 0.5 * quadrature[i].at) * step;
                points[i] = point_at(cell, phi, 0.5 * quadrature[i].share * std::abs(step));
            }
            add_points(points);
        }
    }

    // A wavelength, by its x, and what its colour weighs.
    struct Point {
        double cosine, x, y, z;
    };
    using Points = std::array<Point, quadrature.size()>;

    Point point_at(std::size_t cell, double phi, double share) const {
        const double cosine = std::cos(phi);
        const double nm = 1.0 / panel_.wavenumber(cosine);
        const double along =
            std::clamp(nm * weights_.cells_per_nm - weights_.first_cell() - static_cast<double>(cell), 0.0, 1.0);
        // d nm = nm^2 d wavenumber, and d x = sin(phi) d phi.
        const double by_phi = share * nm * nm * 0.5 * (panel_.to - panel_.from) * std::sin(phi) * weights_.cells_per_nm;
        return {cosine, by_phi * weight_at(weights_.x, cell, along), by_phi * weight_at(weights_.y, cell, along),
                by_phi * weight_at(weights_.z, cell, along)};
    }

    // Side by side, which hides the latency of each recurrence.
    void add_points(const Points& points) {
        std::array<double, quadrature.size()> polynomial, before;
        for (std::size_t i = 0; i < points.size(); ++i) {
            polynomial[i] = 1.0;
            before[i] = points[i].cosine;
        }
        for (std::size_t n = 0; n < x_.size(); ++n) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                x_[n] += points[i].x * polynomial[i];
                y_[n] += points[i].y * polynomial[i];
                z_[n] += points[i].z * polynomial[i];
                const double next = 2.0 * points[i].cosine * polynomial[i] - before[i];
                before[i] = polynomial[i];
                polynomial[i] = next;
            }
        }
    }

    const TristimulusWeights& weights_;
    const Panel& panel_;
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> z_;
};

void add_panel(const TristimulusWeights& weights, const Panel& panel, int count, SpectralNodes& nodes) {
    const Moments moments(weights, panel, count);
    const auto size = static_cast<std::size_t>(count);
    // cos(pi k / 2N) for all k: the polynomials at the nodes.
    std::vector<double> cosines(4 * size);
    for (std::size_t k = 0; k < cosines.size(); ++k)
        cosines[k] = std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * size));
    for (std::size_t j = 0; j < size; ++j) {
        nodes.wavelength_nm.push_back(1.0 / panel.wavenumber(cosines[2 * j + 1]));
        double x = 0.5 * moments.x()[0];
        double y = 0.5 * moments.y()[0];
        double z = 0.5 * moments.z()[0];
        std::size_t k = 0;
        for (std::size_t n = 1; n < size; ++n) {
            k += 2 * j + 1;
            if (k >= cosines.size()) k -= cosines.size();
            const double polynomial = cosines[k];
            x += moments.x()[n] * polynomial;
            y += moments.y()[n] * polynomial;
            z += moments.z()[n] * polynomial;
        }
        nodes.x.push_back(2.0 * x / count);
        nodes.y.push_back(2.0 * y / count);
        nodes.z.push_back(2.0 * z / count);
    }
}

void pad(SpectralNodes& nodes) {
    nodes.count = static_cast<int>(nodes.x.size());
    for (auto* weights : {&nodes.x, &nodes.y, &nodes.z}) {
        while (weights->size() % SpectralNodes::padding != 0) weights->push_back(0.0);
    }
}

}  // namespace

SpectralNodes make_spectral_nodes(const TristimulusWeights& weights, int count) {
    const int panels = (count + most_nodes_per_panel - 1) / most_nodes_per_panel;
    const Panel whole{1.0 / weights.last_nm, 1.0 / weights.first_nm};
    SpectralNodes nodes;
    for (int i = 0; i < panels; ++i) {
        const double width = (whole.to - whole.from) / panels;
        const Panel panel{whole.from + i * width, i + 1 == panels ? whole.to : whole.from + (i + 1) * width};
        add_panel(weights, panel, count / panels + (i < count % panels ? 1 : 0), nodes);
    }
    pad(nodes);
    return nodes;
}

SpectralNodes make_spectral_nodes(const GridWeights& weights, const WavelengthGrid& grid) {
    SpectralNodes nodes;
    for (int i = 0; i < grid.count; ++i) nodes.wavelength_nm.push_back(grid.wavelength_nm(i));
    nodes.x = weights.x;
    nodes.y = weights.y;
    nodes.z = weights.z;
    pad(nodes);
    return nodes;
}

}  // namespace nacre
