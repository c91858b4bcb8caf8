#include "nacre/bake/bake.h"

#include <cstddef>

namespace nacre {
namespace {

// One row per mechanism: what answers for it at many angles.
struct Prepare {
    PaletteCurve operator()(const Palette& palette) const { return PaletteCurve(palette); }
};

// A mechanism made ready to be asked at many angles.
class Sampler {
public:
    Sampler(const Mechanism& mechanism, const Light& light) : light_(light), curve_(std::visit(Prepare{}, mechanism)) {}

    Xyz at(const Incidence& incidence) const {
        const Lobe lobe = curve_.at(incidence);
        if (!light_.settings.wavelengths) {
            return lobe_to_xyz(light_.weights, lobe.peak_nm, lobe.width_nm, lobe.height);
        }
        Spectrum spectrum{light_.grid, {}};
        spectrum.value.reserve(static_cast<std::size_t>(light_.grid.count));
        for (int node = 0; node < light_.grid.count; ++node) {
            spectrum.value.push_back(lobe_reflectance(lobe, light_.grid.wavelength_nm(node)));
        }
        return to_xyz(light_.grid_weights, spectrum);
    }

private:
    const Light& light_;
    PaletteCurve curve_;
};

// The material as it is at one point of the parameter axes.
Mechanism mechanism_at(const Job& job, double x, double y) {
    Mechanism mechanism = job.material.mechanism;
    if (!job.x.is_angle()) job.x.parameter.set(mechanism, job.x.parameter_value(x));
    if (job.y && !job.y->is_angle()) job.y->parameter.set(mechanism, job.y->parameter_value(y));
    return mechanism;
}

Incidence incidence_at(const Job& job, double x, double y) {
    if (job.x.is_angle()) return job.x.kind->incidence(x);
    if (job.y && job.y->is_angle()) return job.y->kind->incidence(y);
    return Incidence::from_degrees(job.angle_deg);
}

}  // namespace

Spectrum reflectance(const Mechanism& mechanism, const Incidence& incidence, const WavelengthGrid& grid) {
    const Lobe lobe = std::visit(Prepare{}, mechanism).at(incidence);
    Spectrum spectrum{grid, {}};
    for (int node = 0; node < grid.count; ++node) {
        spectrum.value.push_back(lobe_reflectance(lobe, grid.wavelength_nm(node)));
    }
    return spectrum;
}

Response response_at(const Mechanism& mechanism, const Incidence& incidence, double wavelength_nm) {
    const double r = lobe_reflectance(std::visit(Prepare{}, mechanism).at(incidence), wavelength_nm);
    return {r, r, 0.0, 0.0};
}

Xyz reflectance_xyz(const Mechanism& mechanism, const Incidence& incidence, const Light& light) {
    return Sampler(mechanism, light).at(incidence);
}

Xyz exact_xyz(const Job& job, double x, double y) {
    const Xyz seen = reflectance_xyz(mechanism_at(job, x, y), incidence_at(job, x, y), *job.light);
    return adapt(job.light->adaptation, seen);
}

Image<Xyz> bake(const Job& job, const AfterRow& after_row) {
    Image<Xyz> image(job.width, job.height);
    const bool rows_share_material = job.x.is_angle();
    for (int row = 0; row < job.height; ++row) {
        const double y = job.height > 1 ? coordinate_of_texel(row, job.height) : 0.0;
        std::optional<Sampler> sampler;
        for (int column = 0; column < job.width; ++column) {
            const double x = coordinate_of_texel(column, job.width);
            if (!sampler || !rows_share_material) sampler.emplace(mechanism_at(job, x, y), *job.light);
            image.at(column, row) = adapt(job.light->adaptation, sampler->at(incidence_at(job, x, y)));
        }
        if (after_row) after_row();
    }
    return image;
}

}  // namespace nacre
