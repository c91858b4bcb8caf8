#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/layer_system.h"
#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/optics/multilayer/multilayer_kernel.h"
#include "nacre/optics/polarisation.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/optics/response.h"
#include "nacre/optics/transverse.h"

namespace nacre {
namespace {

// Nodes as steps whose members lie side by side, groups after the steps that they are among.
class StepBuilder {
public:
    StepBuilder(const std::vector<LayerNode>& nodes, std::vector<LayerStep>& steps) : nodes_(nodes), steps_(steps) {}

    // The siblings in [begin, end) become steps [first, last), which are returned.
    std::pair<int, int> add(std::size_t begin, std::size_t end) {
        const auto first = static_cast<int>(steps_.size());
        std::vector<std::pair<std::size_t, std::size_t>> groups;  // step, node
        for (std::size_t i = begin; i < end; ++i) {
            const LayerNode& node = nodes_[i];
            if (node.repeat > 0) groups.emplace_back(steps_.size(), i);
            steps_.push_back({node.thickness_nm, node.medium, node.repeat, 0, 0, false, 0});
            i += static_cast<std::size_t>(node.count);
        }
        const auto last = static_cast<int>(steps_.size());
        for (const auto& [step, node] : groups) {
            const auto members = add(node + 1, node + 1 + static_cast<std::size_t>(nodes_[node].count));
            steps_[step].first = members.first;
            steps_[step].last = members.second;
            constexpr int few = 4;
            steps_[step].is_short = members.second - members.first <= few &&
                                    std::all_of(steps_.begin() + members.first, steps_.begin() + members.second,
                                                [](const LayerStep& member) { return member.repeat == 0; });
        }
        return {first, last};
    }

private:
    const std::vector<LayerNode>& nodes_;
    std::vector<LayerStep>& steps_;
};

void split_into_parts(const LayerSystem& system, PreparedLayers& prepared) {
    StepBuilder builder(system.nodes, prepared.steps);
    int above = system.incident;
    std::size_t begin = 0;
    const auto close = [&](std::size_t end, int below) {
        const auto [first, last] = builder.add(begin, end);
        prepared.parts.push_back({above, below, first, last});
        above = below;
        begin = end + 1;
    };
    for (std::size_t i = 0; i < system.nodes.size(); ++i) {
        const LayerNode& node = system.nodes[i];
        if (!node.is_incoherent) {
            i += static_cast<std::size_t>(node.count);
            continue;
        }
        close(i, node.medium);
        prepared.incoherent.push_back({node.thickness_nm, node.medium, 0, 0, 0, false, 0});
    }
    close(system.nodes.size(), system.substrate);
}

// |n|^2 over all wavelengths.
struct Norms {
    double least = std::numeric_limits<double>::infinity();
    double largest = 0.0;

    void add(double norm) {
        least = std::min(least, norm);
        largest = std::max(largest, norm);
    }
};

// Of a medium whose index lies between two: no larger, and no smaller than by a factor of 2.
Norms norms_between(const Norms& one, const Norms& other) {
    return {std::min(one.least, other.least), std::max(one.largest, other.largest)};
}

// Of a medium whose permittivity lies between two. It may be next to nothing, as that of a metal is negative.
Norms norms_of_permittivity(const PreparedLayers& prepared, const Medium& medium) {
    const auto permittivity = [&](int curve, std::size_t i) {
        const std::size_t at = static_cast<std::size_t>(curve) * prepared.wavelengths + i;
        const RefractiveIndex n(prepared.n[at], prepared.k[at]);
        return n * n;
    };
    Norms norms;
    for (std::size_t i = 0; i < prepared.wavelengths; ++i) {
        norms.add(std::abs((1.0 - medium.share) * permittivity(medium.curve, i) +
                           medium.share * permittivity(medium.other, i)));
    }
    return norms;
}

// Bounds on the entries of layers' matrices: cos a, sin a / q, q sin a, and the latter two times and over n^2.
// @param of_curve  |n|^2 of every curve
void set_growths(const std::vector<Norms>& of_curve, std::span<const double> wavelength_nm, PreparedLayers& prepared) {
    std::vector<Norms> of_medium;
    for (const Medium& medium : prepared.media) {
        const Norms& curve = of_curve[static_cast<std::size_t>(medium.curve)];
        if (medium.share == 0.0) {
            of_medium.push_back(curve);
        } else if (medium.mixing == Mixing::index) {
            of_medium.push_back(norms_between(curve, of_curve[static_cast<std::size_t>(medium.other)]));
        } else {
            of_medium.push_back(norms_of_permittivity(prepared, medium));
        }
    }
    double least_nm = std::numeric_limits<double>::infinity();
    for (const double nm : wavelength_nm) least_nm = std::min(least_nm, nm);
    const double n0_squared = prepared.largest_n0 * prepared.largest_n0;
    for (LayerStep& step : prepared.steps) {
        if (step.repeat > 0) continue;
        const auto [least, largest] = of_medium[static_cast<std::size_t>(step.medium)];
        const double q = std::sqrt(largest + n0_squared);
        const double path = 2.0 * std::numbers::pi * step.thickness_nm / least_nm;
        const double entry = std::max({1.0, path, path * largest, q, q / least});
        // A field is a sum of two products of at most two parts each, and a scale is off by a factor of less than 2;
        // a mixture may be smaller than either of its materials, by another.
        constexpr double sums = 4.0;
        constexpr double most = 50.0;  // is a size of 1e15, and there are at most four layers between two looks
        step.growth = static_cast<int>(std::min(std::ceil(std::log2(entry)) + sums, most));
    }
}

void sample_indices(const LayerSystem& system, std::span<const double> wavelength_nm, PreparedLayers& prepared) {
    std::vector<double> least(system.curves.size(), std::numeric_limits<double>::infinity());
    std::vector<double> largest(system.curves.size(), 0.0);
    std::vector<char> lossless(system.curves.size(), 1);
    std::vector<Norms> norms(system.curves.size());
    const std::size_t count = wavelength_nm.size();
    prepared.n.resize(system.curves.size() * count);
    prepared.k.resize(prepared.n.size());
    for (std::size_t curve = 0; curve < system.curves.size(); ++curve) {
        const std::span n(prepared.n.data() + curve * count, count), k(prepared.k.data() + curve * count, count);
        const std::size_t different = system.curves[curve].is_constant() ? std::min<std::size_t>(count, 1) : count;
        for (std::size_t i = 0; i < different; ++i) {
            const RefractiveIndex index = system.curves[curve].at(wavelength_nm[i]);
            n[i] = index.real();
            k[i] = index.imag();
            least[curve] = std::min(least[curve], index.real());
            largest[curve] = std::max(largest[curve], index.real());
            if (index.imag() != 0.0) lossless[curve] = 0;
            norms[curve].add(std::norm(index));
        }
        for (std::size_t i = different; i < count; ++i) {
            n[i] = n[0];
            k[i] = k[0];
        }
    }
    for (const Medium& medium : system.media) {
        const auto curve = static_cast<std::size_t>(medium.curve);
        const auto other = medium.share == 0.0 ? curve : static_cast<std::size_t>(medium.other);
        prepared.least_n.push_back(std::min(least[curve], least[other]));
        prepared.is_lossless.push_back(lossless[curve] && lossless[other]);
    }
    const auto incident = static_cast<std::size_t>(system.media[static_cast<std::size_t>(system.incident)].curve);
    prepared.largest_n0 = largest[incident];
    for (const Medium& medium : system.media) {
        // Refraction depends on the incident medium too.
        const auto other = static_cast<std::size_t>(medium.share == 0.0 ? medium.curve : medium.other);
        prepared.is_dispersive.push_back(system.curves[static_cast<std::size_t>(medium.curve)].is_dispersive() ||
                                         system.curves[other].is_dispersive() ||
                                         system.curves[incident].is_dispersive());
    }
    set_growths(norms, wavelength_nm, prepared);
}

}  // namespace

MultilayerSolver::MultilayerSolver(const LayerSystem& system, std::span<const double> wavelengths_nm)
    : count_(wavelengths_nm.size()) {
    auto prepared = std::make_shared<PreparedLayers>();
    std::vector<double> padded(wavelengths_nm.begin(), wavelengths_nm.end());
    while (padded.size() % PreparedLayers::padding != 0) padded.push_back(padded.back());
    prepared->wavelengths = padded.size();
    prepared->quarter_turns_per_nm.resize(padded.size());
    std::transform(padded.begin(), padded.end(), prepared->quarter_turns_per_nm.begin(),
                   [](double nm) { return 4.0 / nm; });
    prepared->media = system.media;
    prepared->incident = system.incident;
    prepared->substrate = system.substrate;
    split_into_parts(system, *prepared);
    sample_indices(system, padded, *prepared);
    prepared_ = std::move(prepared);
}

std::size_t MultilayerSolver::padded_count() const {
    return prepared_->wavelengths;
}

namespace {

LayersAtAngle at_angle(const PreparedLayers& layers, const Incidence& incidence) {
    LayersAtAngle angle{&layers, Transverse(incidence), {}, {}};
    // Conservative where the incident medium is dispersive: its largest index makes waves evanescent first.
    const double n0 = layers.largest_n0;
    const double u = n0 * angle.transverse.u_per_n0;
    const double v = n0 * n0 * angle.transverse.v_per_n0_squared;
    for (std::size_t i = 0; i < layers.media.size(); ++i) {
        const double n = layers.least_n[i];
        angle.is_plain.push_back(layers.is_lossless[i] && n > 0.0 && (n - u) * (n + u) + v >= 0.0);
    }
    // Members lie behind their group.
    angle.is_plain_step.resize(layers.steps.size());
    for (std::size_t i = layers.steps.size(); i-- > 0;) {
        const LayerStep& step = layers.steps[i];
        if (step.repeat == 0) {
            angle.is_plain_step[i] = angle.is_plain[static_cast<std::size_t>(step.medium)];
        } else {
            angle.is_plain_step[i] =
                std::all_of(angle.is_plain_step.begin() + step.first, angle.is_plain_step.begin() + step.last,
                            [](char is_plain) { return is_plain != 0; });
        }
    }
    return angle;
}

}  // namespace

void MultilayerSolver::responses(const Incidence& incidence, std::span<Response> out) const {
    std::vector<Response> padded(prepared_->wavelengths);
    multilayer_responses(at_angle(*prepared_, incidence), padded.data());
    std::copy_n(padded.begin(), count_, out.begin());
}

std::array<double, 3> MultilayerSolver::weighted_reflectances(const Incidence& incidence,
                                                              const std::array<const double*, 3>& weights,
                                                              Polarisation polarisation) const {
    return weighted(incidence, weights, Observed::reflectance, polarisation);
}

std::array<double, 3> MultilayerSolver::weighted(const Incidence& incidence,
                                                 const std::array<const double*, 3>& weights, Observed observed,
                                                 Polarisation polarisation) const {
    return multilayer_weighted(at_angle(*prepared_, incidence), weights, observed, polarisation);
}

}  // namespace nacre
