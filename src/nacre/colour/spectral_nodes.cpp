#include "nacre/colour/spectral_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

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

double weight_at(const std::vector<double>& weights, std::size_t cell, double along) {
    return std::lerp(weights[cell], weights[cell + 1], along);
}

}  // namespace

// An interval of the wavenumber, in 1 / nm.
struct NodeMaker::Panel {
    double from;
    double to;

    double wavenumber(double x) const { return 0.5 * ((from + to) + x * (to - from)); }
    double x(double wavenumber) const { return std::clamp((2.0 * wavenumber - (from + to)) / (to - from), -1.0, 1.0); }
};

// Integrals over wavelength of the weights times the Chebyshev polynomials of x, degree by degree.
class NodeMaker::Moments {
public:
    // Degrees 0 to `degrees` - 1 at least. @param weights  have to outlive this
    Moments(const TristimulusWeights& weights, const Panel& panel, int degrees)
        : weights_(&weights),
          panel_(panel),
          x_((static_cast<std::size_t>(degrees) + side_by_side - 1) / side_by_side * side_by_side),
          y_(x_),
          z_(x_) {
        const double shortest_nm = 1.0 / panel.to;
        const double longest_nm = 1.0 / panel.from;
        const double per_nm = weights.cells_per_nm;
        for (double left = std::max(shortest_nm, static_cast<double>(weights.first_nm)); left < longest_nm;) {
            const double right = std::min((std::floor(left * per_nm + 1e-9) + 1.0) / per_nm, longest_nm);
            add_cell(left, right);
            left = right;
        }
    }

    int degrees() const { return static_cast<int>(x_.size()); }

    // Adds the panel's nodes. @param count  up to the number of degrees
    void add_nodes(int count, SpectralNodes& nodes) const {
        const auto size = static_cast<std::size_t>(count);
        // cos(pi k / 2N) for all k: the polynomials at the nodes.
        std::vector<double> cosines(4 * size);
        for (std::size_t k = 0; k < cosines.size(); ++k)
            cosines[k] = std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * size));
        for (std::size_t j = 0; j < size; ++j) {
            nodes.wavelength_nm.push_back(1.0 / panel_.wavenumber(cosines[2 * j + 1]));
            double x = 0.5 * x_[0];
            double y = 0.5 * y_[0];
            double z = 0.5 * z_[0];
            std::size_t k = 0;
            for (std::size_t n = 1; n < size; ++n) {
                k += 2 * j + 1;
                if (k >= cosines.size()) k -= cosines.size();
                const double polynomial = cosines[k];
                x += x_[n] * polynomial;
                y += y_[n] * polynomial;
                z += z_[n] * polynomial;
            }
            nodes.x.push_back(2.0 * x / count);
            nodes.y.push_back(2.0 * y / count);
            nodes.z.push_back(2.0 * z / count);
        }
    }

private:
    // So many degrees are computed at once, for the compiler to put them into registers.
    static constexpr std::size_t side_by_side = 8;

    // Within one cell the weights are linear. The polynomials are cos(n phi) with x = cos(phi), whose phase must not
    // run far between the nodes of the quadrature.
    void add_cell(double left, double right) {
        const double phi_left = std::acos(panel_.x(1.0 / left));
        const double phi_right = std::acos(panel_.x(1.0 / right));
        constexpr double longest_phase = 1.5;
        const double phase = std::abs(phi_right - phi_left) * static_cast<double>(x_.size());
        const int parts = std::max(1, static_cast<int>(std::ceil(phase / longest_phase)));
        const double from_first_nm = std::max(0.5 * (left + right) - weights_->first_nm, 0.0);
        const auto cell = std::min(static_cast<std::size_t>(from_first_nm * weights_->cells_per_nm),
                                   static_cast<std::size_t>(weights_->count()) - 2);
        const double step = (phi_right - phi_left) / parts;
        for (int part = 0; part < parts; ++part) {
            for (const QuadratureNode& node : quadrature)
                add_point(cell, phi_left + (part + 0.5 + 0.5 * node.at) * step, 0.5 * node.share * std::abs(step));
        }
    }

    // A wavelength by its phi, and what it counts.
    void add_point(std::size_t cell, double phi, double share) {
        const double cosine = std::cos(phi);
        const double nm = 1.0 / panel_.wavenumber(cosine);
        const double along =
            std::clamp(nm * weights_->cells_per_nm - weights_->first_cell() - static_cast<double>(cell), 0.0, 1.0);
        // d nm = nm^2 d wavenumber, and d x = sin(phi) d phi.
        const double by_phi =
            share * nm * nm * 0.5 * (panel_.to - panel_.from) * std::sin(phi) * weights_->cells_per_nm;
        const double x = by_phi * weight_at(weights_->x, cell, along);
        const double y = by_phi * weight_at(weights_->y, cell, along);
        const double z = by_phi * weight_at(weights_->z, cell, along);
        // T(n + s) = 2 T(s) T(n) - T(n - s): one degree from the next, s of them side by side.
        std::array<double, side_by_side> polynomial, before;
        polynomial[0] = 1.0;
        polynomial[1] = cosine;
        for (std::size_t n = 2; n < side_by_side; ++n)
            polynomial[n] = 2.0 * cosine * polynomial[n - 1] - polynomial[n - 2];
        const double stride = 2.0 * cosine * polynomial[side_by_side - 1] - polynomial[side_by_side - 2];
        for (std::size_t n = 0; n < side_by_side; ++n)
            before[n] = n == 0 ? stride : polynomial[side_by_side - n];  // T(-n) = T(n)
        for (std::size_t first = 0; first < x_.size(); first += side_by_side) {
            for (std::size_t n = 0; n < side_by_side; ++n) {
                x_[first + n] += x * polynomial[n];
                y_[first + n] += y * polynomial[n];
                z_[first + n] += z * polynomial[n];
                const double next = 2.0 * stride * polynomial[n] - before[n];
                before[n] = polynomial[n];
                polynomial[n] = next;
            }
        }
    }

    const TristimulusWeights* weights_;
    Panel panel_;
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> z_;
};

namespace {

void pad(SpectralNodes& nodes) {
    nodes.count = static_cast<int>(nodes.x.size());
    for (auto* weights : {&nodes.x, &nodes.y, &nodes.z}) {
        while (weights->size() % SpectralNodes::padding != 0) weights->push_back(0.0);
    }
}

}  // namespace

const std::vector<NodeMaker::Moments>& NodeMaker::moments(int panels, int degrees) {
    std::shared_ptr<const std::vector<Moments>>& kept = moments_[panels];
    if (kept != nullptr && kept->front().degrees() >= degrees) return *kept;
    // Larger counts come next.
    constexpr int usual_degrees = 64;
    if (kept != nullptr) degrees = degrees <= usual_degrees ? usual_degrees : most_nodes_of_one_panel;
    std::vector<Moments> made;
    const double from = 1.0 / weights_->last_nm;
    const double to = 1.0 / weights_->first_nm;
    const double width = (to - from) / panels;
    for (int i = 0; i < panels; ++i) {
        const Panel panel{from + i * width, i + 1 == panels ? to : from + (i + 1) * width};
        made.emplace_back(*weights_, panel, degrees);
    }
    kept = std::make_shared<const std::vector<Moments>>(std::move(made));
    return *kept;
}

std::shared_ptr<const SpectralNodes> NodeMaker::of(int count) {
    std::shared_ptr<const SpectralNodes>& kept = nodes_[count];
    if (kept != nullptr) return kept;
    int panels = 1;
    while (count > most_nodes_of_one_panel && panels * most_nodes_per_panel < count) panels *= 2;
    const auto count_of = [&](int panel) { return count / panels + (panel < count % panels ? 1 : 0); };
    const std::vector<Moments>& all = moments(panels, count_of(0));
    SpectralNodes nodes;
    for (int i = 0; i < panels; ++i) all[static_cast<std::size_t>(i)].add_nodes(count_of(i), nodes);
    pad(nodes);
    kept = std::make_shared<const SpectralNodes>(std::move(nodes));
    return kept;
}

SpectralNodes make_spectral_nodes(const TristimulusWeights& weights, int count) {
    return *NodeMaker(weights).of(count);
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
