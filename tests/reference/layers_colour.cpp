#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "reference/flat_colour.h"
#include "reference/layers.h"
#include "reference/materials.h"

namespace nacre::reference {
namespace {

class LayersColour : public FlatColour {
public:
    LayersColour(const ModelScene& scene, const ModelLight& light)
        : light_(light),
          y_(scene.y),
          polarisation_(scene.mechanism.effects.polarisation),
          observed_(scene.mechanism.effects.observed),
          samples_(thickness_samples_of(scene.mechanism)) {
        const std::optional<Base>& base = scene.mechanism.effects.base;
        if (!base || std::holds_alternative<MetalBase>(*base)) return;
        // Of 2.5 nm: what comes evenly from everywhere has blurred fringes; finer ones for many layers.
        const int intervals = samples_.front().layers.size() > 20 ? 752 : 188;
        for (int i = 0; i <= intervals; ++i) {
            const double nm = light_begins_nm + (light_ends_nm - light_begins_nm) * static_cast<double>(i) / intervals;
            base_factor_.push_back(base_factor(samples_, *base, nm));
        }
    }

    double longest_step_nm(double x, double y) const override {
        const PlainLayers& layers = samples_.front();
        // Towards grazing either face of a layer in thinner media is a mirror, and its fringes are sharp.
        const double above = index_at(layers.media[0], 550.0).real(), below = index_at(layers.media[1], 550.0).real();
        const double shortest_nm = below < 1.15 * above ? 0.0625 : 1.0;
        double step_nm = 2.0;
        while (step_nm > shortest_nm && step_nm > 16.0 * x * x) step_nm *= 0.5;
        // At most 0.7 radians of the longest round trip, whose phase turns by 4 pi n d / wavelength^2 per nanometre.
        double path_nm = 0.0;
        for (const PlainLayer& layer : at_y(layers, y).layers)
            if (!layer.is_incoherent)
                path_nm += layer.thickness_nm * index_at(layers.media[layer.medium], 450.0).real();
        const double radians_per_nm = 4.0 * std::numbers::pi * path_nm / square(450.0);
        while (step_nm > 0.015625 && step_nm * radians_per_nm > 0.7 * std::clamp(4.0 * x * x, 0.1, 1.0)) step_nm *= 0.5;
        return step_nm;
    }

    double cost() const override {
        const double step_nm = std::min(longest_step_nm(0.7, 0.0), longest_step_nm(0.7, 1.0));
        const PlainLayers& layers = samples_.front();
        // Twice, and the second time at twice as many wavelengths; a medium's root costs as much as two faces.
        return 3.0 * (light_ends_nm - light_begins_nm) / step_nm *
               static_cast<double>((2 + layers.layers.size() + 2 * layers.media.size()) * samples_.size());
    }

    Triple at(double x, double y, double step_nm) const override {
        if (x == 0.0 && observed_ == Observed::transmittance) return {};  // nothing of what runs along a surface enters
        const double cos_theta = std::max(x * x, 1e-9);                   // 90 degrees is the limit from below
        const WavelengthGrid& grid = light_.grid(step_nm);
        const std::vector<MediaAt>& media = media_of(step_nm, grid);
        std::vector<double> spectrum(grid.nm.size(), 0.0);
        for (const PlainLayers& even : samples_) {
            const PlainLayers& sample = y_ ? at_y(even, y) : even;
            for (std::size_t i = 0; i < spectrum.size(); ++i) spectrum[i] += share_seen(sample, media[i], cos_theta);
        }
        return grid.sum(spectrum);
    }

    Triple resolved(double x, double y, double tolerance) const override {
        std::vector<PlainLayers> samples;
        for (const PlainLayers& even : samples_) samples.push_back(at_y(even, y));
        const double cos_theta = std::max(x * x, 1e-9);
        const auto seen_at = [&](double nm) {
            double sum = 0.0;
            for (const PlainLayers& sample : samples) sum += share_seen(sample, media_at_nm(nm), cos_theta);
            return sum;
        };
        Triple sum{};
        double low = seen_at(light_begins_nm);
        for (int nm = light_begins_nm; nm < light_ends_nm; ++nm) {
            const double high = seen_at(nm + 1);
            add_cell({1.0 * nm, nm + 1.0, low, seen_at(nm + 0.5), high}, tolerance, seen_at, sum);
            low = high;
        }
        return sum;
    }

private:
    struct Cell {
        double from_nm, to_nm;
        double low, middle, high;
    };
    // What two points more say of the parabola through three decides; what all five weigh is Boole's rule.
    template <class SeenAt>
    void add_cell(const Cell& cell, double tolerance, const SeenAt& seen_at, Triple& sum) const {
        constexpr double narrowest_nm = 1.0 / 16384.0;
        const double width = cell.to_nm - cell.from_nm, middle_nm = 0.5 * (cell.from_nm + cell.to_nm);
        const double second = seen_at(cell.from_nm + 0.25 * width), fourth = seen_at(cell.from_nm + 0.75 * width);
        const double off = std::max(std::abs(second - (3.0 * cell.low + 6.0 * cell.middle - cell.high) / 8.0),
                                    std::abs(fourth - (3.0 * cell.high + 6.0 * cell.middle - cell.low) / 8.0));
        if (off * width > tolerance && width > narrowest_nm) {
            add_cell({cell.from_nm, middle_nm, cell.low, second, cell.middle}, tolerance, seen_at, sum);
            add_cell({middle_nm, cell.to_nm, cell.middle, fourth, cell.high}, tolerance, seen_at, sum);
            return;
        }
        const std::array<double, 5> seen{7.0 * cell.low, 32.0 * second, 12.0 * cell.middle, 32.0 * fourth,
                                         7.0 * cell.high};
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Triple weight = light_.weight_at(cell.from_nm + 0.25 * width * static_cast<double>(i));
            for (std::size_t c = 0; c < 3; ++c) sum[c] += width / 90.0 * seen[i] * weight[c];
        }
    }
    double share_seen(const PlainLayers& sample, const MediaAt& media, double cos_theta) const {
        double sum = 0.0;
        for (const bool is_p : {false, true}) {
            if (polarisation_ != Polarisation::mean && (polarisation_ == Polarisation::p) != is_p) continue;
            const double share = sample.share * (polarisation_ == Polarisation::mean ? 0.5 : 1.0);
            sum += share * seen(sample, media, {media.index[0].real(), cos_theta, is_p});
        }
        return sum;
    }
    // Kept at multiples of 1/64 nm.
    const MediaAt& media_at_nm(double nm) const {
        const double place = 64.0 * (nm - light_begins_nm);
        if (place != std::floor(place)) return other_media_ = media_at(samples_.front(), nm);
        if (media_by_place_.empty()) media_by_place_.resize(64 * (light_ends_nm - light_begins_nm) + 1);
        MediaAt& media = media_by_place_[static_cast<std::size_t>(place)];
        if (media.index.empty()) media = media_at(samples_.front(), nm);
        return media;
    }
    double seen(const PlainLayers& layers, const MediaAt& media, const Wave& wave) const {
        if (observed_ == Observed::transmittance) return powers_at(layers, media, wave).transmittance;
        if (base_factor_.empty() && layers.is_coherent()) return coherent_reflectance(layers, media, wave);
        const ModelPowers powers = powers_at(layers, media, wave);
        if (base_factor_.empty()) return powers.reflectance;
        return powers.reflectance +
               powers.transmittance *
                   cubic_at(base_factor_, (media.nm - light_begins_nm) / (light_ends_nm - light_begins_nm));
    }
    PlainLayers at_y(PlainLayers layers, double y) const {
        for (std::size_t i = 0; y_ && i < layers.layers.size(); ++i)
            if (layers.written[i] == y_->layer) layers.layers[i].thickness_nm = y_->from + (y_->to - y_->from) * y;
        return layers;
    }
    const std::vector<MediaAt>& media_of(double step_nm, const WavelengthGrid& grid) const {
        std::vector<MediaAt>& made = media_[step_nm];
        if (made.empty())
            for (const double nm : grid.nm) made.push_back(media_at(samples_.front(), nm));
        return made;
    }

    const ModelLight& light_;
    std::optional<ModelParameter> y_;
    Polarisation polarisation_;
    Observed observed_;
    std::vector<PlainLayers> samples_;
    std::vector<double> base_factor_;
    mutable std::map<double, std::vector<MediaAt>> media_;
    mutable std::vector<MediaAt> media_by_place_;
    mutable MediaAt other_media_;
};

}  // namespace

std::unique_ptr<FlatColour> layers_colour(const ModelScene& scene, const ModelLight& light) {
    return std::make_unique<LayersColour>(scene, light);
}

}  // namespace nacre::reference
