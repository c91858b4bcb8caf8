#include "reference/model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/facets.h"
#include "reference/flat_colour.h"
#include "reference/layers.h"
#include "reference/materials.h"
#include "reference/palette.h"

namespace nacre::reference {
namespace {

constexpr double finest_step_nm = 1.0 / 256.0;

std::unique_ptr<FlatColour> flat_colour(const ModelScene& scene, const ModelLight& light) {
    if (const auto* grating = std::get_if<Grating>(&scene.mechanism)) return grating_colour(*grating, light);
    if (const auto* spectra = std::get_if<MeasuredSpectra>(&scene.mechanism)) return measured_colour(*spectra, light);
    if (std::holds_alternative<Scatter>(scene.mechanism)) return scatter_colour(scene.mechanism, light);
    return layers_colour(scene, light);
}

}  // namespace

struct Model::Parts {
    ModelScene scene;
    double tolerance, scale;
    const ModelLight& light;
    std::unique_ptr<PaletteModel> palette;
    std::unique_ptr<FlatColour> flat;
    std::vector<ModelXyz> curve;  // over sqrt(cos), if there are facets
    double brightest = 0.0;
    std::size_t unconverged = 0;

    Parts(const ModelScene& of_scene, double of_tolerance, double of_scale)
        : scene(of_scene),
          tolerance(of_tolerance),
          scale(of_scale),
          light(ModelLight::of(scene.illuminant, scene.observer_deg)) {
        if (const auto* of_picks = std::get_if<Palette>(&scene.mechanism))
            palette = std::make_unique<PaletteModel>(*of_picks, scene.y, light);
        else
            flat = flat_colour(scene, light);
        // What is measured bends at its angles: of the few hundred facets of a tilt each is asked.
        const Relief& relief = scene.mechanism.effects.relief;
        const bool is_measured = std::holds_alternative<MeasuredSpectra>(scene.mechanism);
        if (relief.is_plane() || (is_measured && relief.tilt_deg > 0.0)) return;
        // Palettes bend at their picks, and cost nothing; fringes towards grazing are what others need points for.
        const int intervals = palette ? 8192 : is_measured ? 2048 : 192;
        for (int i = intervals; i >= 0; --i) curve.push_back(without_facets(static_cast<double>(i) / intervals, 0.0));
        std::reverse(curve.begin(), curve.end());
    }

    // By the mechanism's own axis: sqrt(cos(theta)), u / 2 or (1 + cos_scatter) / 2.
    ModelXyz without_facets(double own_x, double y) {
        if (palette) return palette->at(own_x * own_x, y);
        double step_nm = flat->longest_step_nm(own_x, y);
        ModelXyz colour = light.adapted(flat->at(own_x, y, step_nm));
        while (step_nm > finest_step_nm) {
            step_nm *= 0.5;
            const ModelXyz finer = light.adapted(flat->at(own_x, y, step_nm));
            brightest = std::max(brightest, finer.y);
            const double change = difference(colour, finer, scale > 0.0 ? scale : scale_of_brightest(brightest));
            colour = finer;
            if (change <= tolerance) return colour;
        }
        ++unconverged;
        return colour;
    }

    ModelXyz with_facets(double own_x) {
        const double theta_deg =
            2.0 * std::asin(std::sqrt(0.5 * (1.0 - own_x) * (1.0 + own_x))) * 180.0 / std::numbers::pi;
        ModelXyz sum;
        for (const ModelFacet& facet : facets_seen(scene.mechanism.effects.relief, theta_deg)) {
            const double of_facet = std::sqrt(facet.cos_beta);
            sum = plus(sum, facet.share, curve.empty() ? without_facets(of_facet, 0.0) : cubic_at(curve, of_facet));
        }
        return sum;
    }
};

Model::Model(const ModelScene& scene, double tolerance, double scale) : parts_(new Parts(scene, tolerance, scale)) {}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

ModelXyz Model::at(double x, double y) const {
    const ModelAxis axis = parts_->scene.x;
    const bool is_own = axis == ModelAxis::of_mechanism || axis == ModelAxis::sqrt_cos_theta;
    const double own_x = is_own ? x : std::sqrt(cosine_at(axis, x, std::numbers::pi));
    return parts_->scene.mechanism.effects.relief.is_plane() ? parts_->without_facets(own_x, y)
                                                             : parts_->with_facets(own_x);
}

ModelXyz Model::resolved(double own_x, double y, double tolerance) const {
    return parts_->light.adapted(parts_->flat->resolved(own_x, y, tolerance));
}

double Model::cost() const {
    return parts_->flat ? parts_->flat->cost() : 1.0;
}

std::size_t Model::unconverged() const {
    return parts_->unconverged;
}

double reflectance(const Mechanism& mechanism, double cos_theta, double wavelength_nm) {
    const PlainLayers layers = layers_of(mechanism);
    const MediaAt media = media_at(layers, wavelength_nm);
    const auto of = [&](bool is_p) {
        return coherent_reflectance(layers, media, {media.index[0].real(), cos_theta, is_p});
    };
    return 0.5 * (of(false) + of(true));
}

std::vector<double> critical_coordinates(const ModelScene& scene) {
    std::vector<double> coordinates;
    const PlainLayers layers = layers_of(scene.mechanism);
    for (const double nm : {450.0, 550.0, 650.0}) {
        const double n0 = index_at(layers.media[0], nm).real();
        for (const Index& medium : layers.media) {
            const double sine = index_at(medium, nm).real() / n0;
            if (sine >= 1.0) continue;
            const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
            coordinates.push_back(scene.x == ModelAxis::theta_deg   ? std::asin(sine) * 2.0 / std::numbers::pi
                                  : scene.x == ModelAxis::cos_theta ? cosine
                                                                    : std::sqrt(cosine));
        }
    }
    std::sort(coordinates.begin(), coordinates.end());
    coordinates.erase(std::unique(coordinates.begin(), coordinates.end()), coordinates.end());
    return coordinates;
}

}  // namespace nacre::reference
