#include "nacre/accuracy/exact_colour.h"

#include <memory>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/lut/job.h"
#include "nacre/shade/prepared_colour.h"
#include "nacre/shade/spectra.h"
#include "nacre/shade/tilt.h"

namespace nacre {

Xyz reflectance_xyz(const Mechanism& mechanism, const Geometry& geometry, const Light& light) {
    if (light.settings.wavelengths) return to_xyz(light.grid_weights, reflectance(mechanism, geometry, light.grid));
    Job job;
    job.material.mechanism = mechanism;
    job.light = {std::shared_ptr<const Light>(), &light};  // lent for as long as this function runs
    job.x = default_axis(quantity_of(mechanism));
    const SpectralSampling sampling = samples_spectra(mechanism) ? default_sampling(job) : SpectralSampling{};
    PreparedColour prepared = prepare_colour(mechanism, sampling, light);
    Work work;
    if (mechanism.effects.tilt_deg == 0.0) return colour_at(prepared, geometry, work);
    Xyz mean;
    for (const Facet& facet : visible_facets(mechanism.effects.tilt_deg, geometry.incidence)) {
        const Xyz seen = colour_at(prepared, Incidence::from_cos(facet.cos_theta), work);
        mean = {mean.x + facet.share * seen.x, mean.y + facet.share * seen.y, mean.z + facet.share * seen.z};
    }
    return mean;
}

Xyz exact_xyz(const Job& job, double x, double y) {
    const Xyz seen = reflectance_xyz(mechanism_at(job, x, y), geometry_at(job, x, y), *job.light);
    return adapt(job.light->adaptation, seen);
}

}  // namespace nacre
