#include "nacre/bake/bake.h"

#include "nacre/bake/sampler.h"

namespace nacre {
namespace {

// One row per mechanism: what becomes of light at some wavelengths.
struct ResponsesAt {
    const Mechanism& mechanism;
    const Incidence& incidence;
    std::span<const double> wavelengths_nm;

    std::vector<Response> operator()(const Palette& palette) const {
        const Lobe lobe = palette_lobe(palette, incidence);
        std::vector<Response> responses;
        for (const double nm : wavelengths_nm) {
            const double r = lobe_reflectance(lobe, nm);
            responses.push_back({r, r, 0.0, 0.0});
        }
        return responses;
    }
    std::vector<Response> operator()(const Film&) const { return layered(); }
    std::vector<Response> operator()(const Stack&) const { return layered(); }
    std::vector<Response> layered() const {
        return layered_responses(mechanism, incidence, wavelengths_nm, spectrum_realisations);
    }
};

}  // namespace

std::vector<Response> responses_at(const Mechanism& mechanism, const Incidence& incidence,
                                   std::span<const double> wavelengths_nm) {
    return std::visit(ResponsesAt{mechanism, incidence, wavelengths_nm}, mechanism);
}

std::shared_ptr<const IndexCurve> unknown_at(const Mechanism& mechanism, double wavelength_nm) {
    if (!needs_sampling(mechanism)) return nullptr;
    const LayerSystem system = layer_systems(mechanism, 1).front();
    for (const Index& index : system.curves) {
        if (index.is_constant() || index.curve->holds_outside) continue;
        if (wavelength_nm < index.curve->first_nm || wavelength_nm > index.curve->last_nm) return index.curve;
    }
    return nullptr;
}

Response response_at(const Mechanism& mechanism, const Incidence& incidence, double wavelength_nm) {
    return responses_at(mechanism, incidence, {&wavelength_nm, 1}).front();
}

Spectrum reflectance(const Mechanism& mechanism, const Incidence& incidence, const WavelengthGrid& grid) {
    std::vector<double> wavelengths_nm;
    for (int node = 0; node < grid.count; ++node) wavelengths_nm.push_back(grid.wavelength_nm(node));
    Spectrum spectrum{grid, {}};
    for (const Response& response : responses_at(mechanism, incidence, wavelengths_nm))
        spectrum.value.push_back(response.reflectance());
    return spectrum;
}

Xyz reflectance_xyz(const Mechanism& mechanism, const Incidence& incidence, const Light& light) {
    if (light.settings.wavelengths) return to_xyz(light.grid_weights, reflectance(mechanism, incidence, light.grid));
    if (const auto* palette = std::get_if<Palette>(&mechanism)) {
        const Lobe lobe = palette_lobe(*palette, incidence);
        return lobe_to_xyz(light.weights, lobe.peak_nm, lobe.width_nm, lobe.height);
    }
    Job job;
    job.material.mechanism = mechanism;
    job.light = {std::shared_ptr<const Light>(), &light};  // lent for as long as this function runs
    return LayeredColour(mechanism, default_sampling(job)).at(incidence);
}

Xyz exact_xyz(const Job& job, double x, double y) {
    const Xyz seen = reflectance_xyz(mechanism_at(job, x, y), incidence_at(job, x, y), *job.light);
    return adapt(job.light->adaptation, seen);
}

Image<Xyz> bake(const Job& job, const AfterRow& after_row, Work* work) {
    Image<Xyz> image(job.width, job.height);
    Sampler sampler(job);
    for (int row = 0; row < job.height; ++row) {
        const double y = coordinate_of_texel(row, job.height);
        for (int column = 0; column < job.width; ++column) {
            image.at(column, row) = sampler.at(coordinate_of_texel(column, job.width), y);
        }
        if (after_row) after_row();
    }
    if (work != nullptr) {
        *work += sampler.work();
        work->texels += image.size();
    }
    return image;
}

}  // namespace nacre
