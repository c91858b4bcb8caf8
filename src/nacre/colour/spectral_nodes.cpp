#include "nacre/colour/spectral_nodes.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace nacre {
namespace {

// The Chebyshev polynomials at a panel's nodes: cos(pi n (2 j + 1) / 2 count) for every degree n and node j, degree by
// degree.
std::vector<double> polynomials_at_nodes(std::size_t count) {
    std::vector<double> cosines(4 * count);  // cos(pi k / 2 count) for all k
    for (std::size_t k = 0; k < cosines.size(); ++k)
        cosines[k] = std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * count));
    std::vector<double> polynomials;
    polynomials.reserve(count * count);
    for (std::size_t n = 0; n < count; ++n) {
        std::size_t k = n;
        for (std::size_t j = 0; j < count; ++j) {
            polynomials.push_back(cosines[k]);
            k += 2 * n;
            if (k >= cosines.size()) k -= cosines.size();
        }
    }
    return polynomials;
}

// The weights of a panel's nodes, behind those that are there.
void append_weights(const std::vector<double>& moments, const std::vector<double>& polynomials, std::size_t count,
                    std::vector<double>& weights) {
    const std::size_t first = weights.size();
    weights.resize(first + count, moments[0] / static_cast<double>(count));
    for (std::size_t n = 1; n < count; ++n) {
        const double moment = 2.0 * moments[n] / static_cast<double>(count);
        for (std::size_t j = 0; j < count; ++j) weights[first + j] += moment * polynomials[n * count + j];
    }
}

void pad(SpectralNodes& nodes) {
    nodes.count = static_cast<int>(nodes.x.size());
    for (auto* weights : {&nodes.x, &nodes.y, &nodes.z}) {
        while (weights->size() % SpectralNodes::padding != 0) weights->push_back(0.0);
    }
}

}  // namespace

const std::vector<ChebyshevMoments>& NodeMaker::moments(int panels, int degrees) {
    std::vector<ChebyshevMoments>& kept = moments_[panels];
    if (!kept.empty() && kept.front().degrees() >= degrees) return kept;
    kept.clear();
    // Larger counts come next.
    const int made = degrees <= most_nodes_per_panel ? most_nodes_per_panel : most_nodes_of_one_panel;
    for (int i = 0; i < panels; ++i) kept.push_back(chebyshev_moments(*weights_, panel_of(i, panels), made));
    return kept;
}

std::shared_ptr<const SpectralNodes> NodeMaker::of(int count) {
    std::shared_ptr<const SpectralNodes>& kept = nodes_[count];
    if (kept != nullptr) return kept;
    int panels = 1;
    while (count > most_nodes_of_one_panel && panels * most_nodes_per_panel < count) panels *= 2;
    // The first few panels may have one more.
    const int fewer = count / panels;
    const int panels_with_more = count % panels;
    const std::vector<ChebyshevMoments>& all = moments(panels, panels_with_more > 0 ? fewer + 1 : fewer);
    SpectralNodes nodes;
    std::vector<double> polynomials;
    for (int i = 0; i < panels; ++i) {
        const int in_panel = i < panels_with_more ? fewer + 1 : fewer;
        const auto size = static_cast<std::size_t>(in_panel);
        if (polynomials.size() != size * size) polynomials = polynomials_at_nodes(size);
        const WavenumberPanel panel = panel_of(i, panels);
        for (std::size_t j = 0; j < size; ++j)
            nodes.wavelength_nm.push_back(1.0 / panel.wavenumber(polynomials[size + j]));
        const ChebyshevMoments& here = all[static_cast<std::size_t>(i)];
        append_weights(here.x, polynomials, size, nodes.x);
        append_weights(here.y, polynomials, size, nodes.y);
        append_weights(here.z, polynomials, size, nodes.z);
    }
    pad(nodes);
    kept = std::make_shared<const SpectralNodes>(std::move(nodes));
    return kept;
}

WavenumberPanel NodeMaker::panel_of(int i, int panels) const {
    const double from = 1.0 / weights_->last_nm;
    const double to = 1.0 / weights_->first_nm;
    const double width = (to - from) / panels;
    return {from + i * width, i + 1 == panels ? to : from + (i + 1) * width};
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
