#include <algorithm>
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
          samples_(thickness_samples_of(scene.mechanism)) {
        const std::optional<Base>& base = scene.mechanism.effects.base;
        if (!base || std::holds_alternative<MetalBase>(*base)) return;
        constexpr int intervals = 188;  // of 2.5 nm: what comes evenly from everywhere has blurred fringes
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
        const double cos_theta = std::max(x * x, 1e-9);  // 90 degrees is the limit from below
        const WavelengthGrid& grid = light_.grid(step_nm);
        const std::vector<MediaAt>& media = media_of(step_nm, grid);
        std::vector<double> spectrum(grid.nm.size(), 0.0);
        for (const PlainLayers& even : samples_) {
            const PlainLayers& sample = y_ ? at_y(even, y) : even;
            for (std::size_t i = 0; i < spectrum.size(); ++i) {
                for (const bool is_p : {false, true}) {
                    if (polarisation_ != Polarisation::mean && (polarisation_ == Polarisation::p) != is_p) continue;
                    const double share = sample.share * (polarisation_ == Polarisation::mean ? 0.5 : 1.0);
                    const Wave wave{media[i].index[0].real(), cos_theta, is_p};
                    spectrum[i] += share * seen(sample, media[i], wave);
                }
            }
        }
        return grid.sum(spectrum);
    }

private:
    double seen(const PlainLayers& layers, const MediaAt& media, const Wave& wave) const {
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
    std::vector<PlainLayers> samples_;
    std::vector<double> base_factor_;
    mutable std::map<double, std::vector<MediaAt>> media_;
};

}  // namespace

std::unique_ptr<FlatColour> layers_colour(const ModelScene& scene, const ModelLight& light) {
    return std::make_unique<LayersColour>(scene, light);
}

}  // namespace nacre::reference
