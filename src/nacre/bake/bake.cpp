#include "nacre/bake/bake.h"

#include "nacre/bake/sampler.h"

namespace nacre {
namespace {

// One row per mechanism: its reflectance at one angle, as a function of wavelength.
struct At {
    Incidence incidence;
    Lobe operator()(const Palette& palette) const { return palette_lobe(palette, incidence); }
};

}  // namespace

Spectrum reflectance(const Mechanism& mechanism, const Incidence& incidence, const WavelengthGrid& grid) {
    const Lobe lobe = std::visit(At{incidence}, mechanism);
    Spectrum spectrum{grid, {}};
    for (int node = 0; node < grid.count; ++node) {
        spectrum.value.push_back(lobe_reflectance(lobe, grid.wavelength_nm(node)));
    }
    return spectrum;
}

Response response_at(const Mechanism& mechanism, const Incidence& incidence, double wavelength_nm) {
    const double r = lobe_reflectance(std::visit(At{incidence}, mechanism), wavelength_nm);
    return {r, r, 0.0, 0.0};
}

Xyz reflectance_xyz(const Mechanism& mechanism, const Incidence& incidence, const Light& light) {
    if (light.settings.wavelengths) return to_xyz(light.grid_weights, reflectance(mechanism, incidence, light.grid));
    const Lobe lobe = std::visit(At{incidence}, mechanism);
    return lobe_to_xyz(light.weights, lobe.peak_nm, lobe.width_nm, lobe.height);
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
