#include "nacre/cost/baselines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/matrix.hpp>
#include <numbers>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/observer.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/colour/whole_cells.h"

namespace nacre {
namespace {

// The nodes of an even grid that lie under a band: first and count; none where the band is narrower than a step.
struct NodeRange {
    int first;
    int count;
};
NodeRange nodes_under(const Lobe& lobe, int first_nm, int step_nm, int node_count) {
    const double from = (lobe.peak_nm - 0.5 * lobe.width_nm - first_nm) / step_nm;
    const double to = (lobe.peak_nm + 0.5 * lobe.width_nm - first_nm) / step_nm;
    const int first = static_cast<int>(std::ceil(std::clamp(from, 0.0, static_cast<double>(node_count))));
    const int last = static_cast<int>(std::floor(std::clamp(to, -1.0, node_count - 1.0)));
    return {first, std::max(last - first + 1, 0)};
}

void add_node(double nm, const Xyz& weight, SpectralNodes& nodes) {
    nodes.wavelength_nm.push_back(nm);
    nodes.x.push_back(weight.x);
    nodes.y.push_back(weight.y);
    nodes.z.push_back(weight.z);
    nodes.count = static_cast<int>(nodes.x.size());
}

SpectralNodes padded(SpectralNodes nodes) {
    for (auto* weights : {&nodes.x, &nodes.y, &nodes.z}) {
        while (weights->size() % SpectralNodes::padding != 0) weights->push_back(0.0);
    }
    return nodes;
}

class SumBaseline final : public Baseline {
public:
    SumBaseline(const Light& light, int step_nm) : first_nm_(light.weights.first_nm), step_nm_(step_nm) {
        Xyz white;
        for (int i = 0; i < light.weights.count(); i += step_nm * light.weights.cells_per_nm) {
            const auto node = static_cast<std::size_t>(i);
            x_.push_back(light.weights.x[node]);
            y_.push_back(light.weights.y[node]);
            z_.push_back(light.weights.z[node]);
            white = {white.x + x_.back(), white.y + y_.back(), white.z + z_.back()};
        }
        count_ = static_cast<int>(x_.size());
        const double luminance = white.y;
        for (auto* weights : {&x_, &y_, &z_}) {
            for (double& weight : *weights) weight /= luminance;
            weights->insert(weights->end(), TristimulusWeights::padding, 0.0);
        }
        adaptation_ =
            adaptation_matrix(light.settings.adaptation, {white.x / luminance, 1.0, white.z / luminance}, d65_white);
    }

    Xyz to_xyz(const Lobe& lobe) const override {
        if (lobe.floor != 0.0 || lobe.flatness != 0.0) return sum_of_all_nodes(lobe);
        const NodeRange nodes = nodes_under(lobe, first_nm_, step_nm_, count_);
        if (nodes.count == 0 || lobe.width_nm == 0.0) return {};
        const double per_nm = std::numbers::pi / lobe.width_nm;
        const double first = per_nm * (first_nm_ + nodes.first * step_nm_ - lobe.peak_nm);
        const double step = per_nm * step_nm_;
        const auto begin = static_cast<std::size_t>(nodes.first);
        const Xyz sum = weighted_cosines(x_.data() + begin, y_.data() + begin, z_.data() + begin,
                                         static_cast<std::size_t>(nodes.count), {std::cos(first), std::sin(first)},
                                         {std::cos(step), std::sin(step)});
        return adapt(adaptation_, {lobe.height * sum.x, lobe.height * sum.y, lobe.height * sum.z});
    }

    // What each of its wavelengths weighs.
    SpectralNodes nodes(const Light& light) const {
        SpectralNodes nodes;
        const glm::dmat3 back = glm::inverse(light.adaptation) * adaptation_;
        for (int i = 0; i < count_; ++i) {
            const auto node = static_cast<std::size_t>(i);
            add_node(first_nm_ + i * step_nm_, adapt(back, {x_[node], y_[node], z_[node]}), nodes);
        }
        return nodes;
    }

private:
    // Where the band is more than one half cosine.
    Xyz sum_of_all_nodes(const Lobe& lobe) const {
        Xyz sum;
        for (int i = 0; i < count_; ++i) {
            const auto node = static_cast<std::size_t>(i);
            const double r = lobe_reflectance(lobe, first_nm_ + i * step_nm_);
            sum = {sum.x + r * x_[node], sum.y + r * y_[node], sum.z + r * z_[node]};
        }
        return adapt(adaptation_, sum);
    }

    int first_nm_;
    int step_nm_;
    int count_ = 0;
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> z_;
    glm::dmat3 adaptation_;
};

// The wavelength whose colour lies in the same direction from white as a primary's.
double dominant_wavelength_nm(Chromaticity primary) {
    const auto direction = [](Chromaticity c) {
        return std::atan2(c.y - d65_chromaticity.y, c.x - d65_chromaticity.x);
    };
    const double wanted = direction(primary);
    double best_nm = 0.0;
    double least = 10.0;
    for (int nm = 420; nm <= 680; ++nm) {
        const auto& bars = colour_matching(Observer::cie1931_2deg, nm);
        const double off = std::abs(
            std::remainder(direction(chromaticity_of({bars[0], bars[1], bars[2]})) - wanted, 2.0 * std::numbers::pi));
        if (off < least) {
            least = off;
            best_nm = nm;
        }
    }
    return best_nm;
}

class ThreeWavelengthsBaseline final : public Baseline {
public:
    ThreeWavelengthsBaseline() {
        const RgbPrimaries primaries = *primaries_by_interop_id("lin_rec709_scene");
        nm_ = {dominant_wavelength_nm(primaries.red), dominant_wavelength_nm(primaries.green),
               dominant_wavelength_nm(primaries.blue)};
        to_xyz_ = glm::inverse(xyz_to_rgb_matrix(primaries));
    }

    Xyz to_xyz(const Lobe& lobe) const override {
        return adapt(to_xyz_,
                     {lobe_reflectance(lobe, nm_[0]), lobe_reflectance(lobe, nm_[1]), lobe_reflectance(lobe, nm_[2])});
    }

    SpectralNodes nodes(const Light& light) const {
        SpectralNodes nodes;
        const glm::dmat3 back = glm::inverse(light.adaptation) * to_xyz_;
        for (int i = 0; i < 3; ++i)
            add_node(nm_[static_cast<std::size_t>(i)], {back[i][0], back[i][1], back[i][2]}, nodes);
        return nodes;
    }

private:
    std::array<double, 3> nm_{};
    glm::dmat3 to_xyz_;
};

double gauss(double nm, double middle, double per_left, double per_right) {
    const double t = (nm - middle) * (nm < middle ? per_left : per_right);
    return std::exp(-0.5 * t * t);
}

// The article's listing 1.
Xyz multi_lobe_fit(double nm) {
    return {0.362 * gauss(nm, 442.0, 0.0624, 0.0374) + 1.056 * gauss(nm, 599.8, 0.0264, 0.0323) -
                0.065 * gauss(nm, 501.1, 0.0490, 0.0382),
            0.821 * gauss(nm, 568.8, 0.0213, 0.0247) + 0.286 * gauss(nm, 530.9, 0.0613, 0.0322),
            1.217 * gauss(nm, 437.0, 0.0845, 0.0278) + 0.681 * gauss(nm, 459.0, 0.0385, 0.0725)};
}

// Its equations 2, of the 2 degree observer.
Xyz single_lobe_fit(double nm) {
    const double y = (std::log(nm) - std::log(556.3)) / 0.075;
    const double z = (std::log(nm) - std::log(449.8)) / 0.051;
    return {1.065 * gauss(nm, 595.8, 1.0 / 33.33, 1.0 / 33.33) + 0.366 * gauss(nm, 446.8, 1.0 / 19.44, 1.0 / 19.44),
            1.014 * std::exp(-0.5 * y * y), 1.839 * std::exp(-0.5 * z * z)};
}

// And of the 10 degree observer.
Xyz single_lobe_fit_10deg(double nm) {
    const double left = std::log((nm + 570.1) / 1014.0);
    const double right = std::log((1338.0 - nm) / 743.5);
    const double z = std::log((nm - 265.8) / 180.4);
    return {0.398 * std::exp(-1250.0 * left * left) + 1.132 * std::exp(-234.0 * right * right),
            1.011 * gauss(nm, 556.1, 1.0 / 46.14, 1.0 / 46.14), 2.060 * std::exp(-32.0 * z * z)};
}

class FitBaseline final : public Baseline {
public:
    FitBaseline(const Light& light, bool single_lobe) : first_nm_(light.weights.first_nm) {
        fit_ = light.settings.observer == Observer::cie1964_10deg ? single_lobe_fit_10deg
               : single_lobe                                      ? single_lobe_fit
                                                                  : multi_lobe_fit;
        Xyz white;
        for (int nm = first_nm_; nm <= light.weights.last_nm; nm += step_nm) {
            power_.push_back(light.settings.power.at(nm));
            add(power_.back(), nm, white);
        }
        for (double& power : power_) power /= white.y;
        adaptation_ =
            adaptation_matrix(light.settings.adaptation, {white.x / white.y, 1.0, white.z / white.y}, d65_white);
    }

    Xyz to_xyz(const Lobe& lobe) const override {
        const int count = static_cast<int>(power_.size());
        const NodeRange nodes = lobe.floor == 0.0 ? nodes_under(lobe, first_nm_, step_nm, count) : NodeRange{0, count};
        Xyz sum;
        for (int i = nodes.first; i < nodes.first + nodes.count; ++i) {
            const double nm = first_nm_ + i * step_nm;
            add(lobe_reflectance(lobe, nm) * power_[static_cast<std::size_t>(i)], nm, sum);
        }
        return adapt(adaptation_, sum);
    }

    SpectralNodes nodes(const Light& light) const {
        SpectralNodes nodes;
        const glm::dmat3 back = glm::inverse(light.adaptation) * adaptation_;
        for (std::size_t i = 0; i < power_.size(); ++i) {
            const double nm = first_nm_ + static_cast<double>(i) * step_nm;
            Xyz weight;
            add(power_[i], nm, weight);
            add_node(nm, adapt(back, weight), nodes);
        }
        return nodes;
    }

private:
    static constexpr int step_nm = 5;

    void add(double factor, double nm, Xyz& sum) const {
        const Xyz bars = fit_(nm);
        sum = {sum.x + factor * bars.x, sum.y + factor * bars.y, sum.z + factor * bars.z};
    }

    int first_nm_;
    Xyz (*fit_)(double nm) = nullptr;
    std::vector<double> power_;
    glm::dmat3 adaptation_;
};

}  // namespace

std::unique_ptr<Baseline> make_sum_baseline(const Light& light, int step_nm) {
    return std::make_unique<SumBaseline>(light, step_nm);
}

SpectralNodes sum_nodes(const Light& light, int step_nm) {
    return padded(SumBaseline(light, step_nm).nodes(light));
}

SpectralNodes three_wavelengths_nodes(const Light& light) {
    return padded(ThreeWavelengthsBaseline().nodes(light));
}

SpectralNodes fit_nodes(const Light& light, bool single_lobe) {
    return padded(FitBaseline(light, single_lobe).nodes(light));
}

std::unique_ptr<Baseline> make_three_wavelengths_baseline() {
    return std::make_unique<ThreeWavelengthsBaseline>();
}

std::unique_ptr<Baseline> make_fit_baseline(const Light& light, bool single_lobe) {
    return std::make_unique<FitBaseline>(light, single_lobe);
}

}  // namespace nacre
