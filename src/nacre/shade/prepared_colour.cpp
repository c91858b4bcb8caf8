#include "nacre/shade/prepared_colour.h"

#include <cstddef>

#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/shade/integral.h"

namespace nacre {
namespace {

// One row per mechanism.
struct Prepare {
    const Mechanism& mechanism;
    const SpectralSampling& sampling;
    const Light& light;
    Integral integral;

    PreparedColour operator()(const Palette& palette) const { return PaletteColour(palette, light, integral); }
    PreparedColour operator()(const Film&) const { return LayeredColour(mechanism, sampling); }
    PreparedColour operator()(const Stack&) const { return LayeredColour(mechanism, sampling); }
    PreparedColour operator()(const Grating& grating) const { return GratingColour(grating, light); }
    PreparedColour operator()(const Crystal&) const { return LayeredColour(mechanism, sampling); }
    PreparedColour operator()(const Scatter&) const { return ScatterColour(mechanism, sampling); }
    PreparedColour operator()(const MeasuredSpectra& spectra) const { return MeasuredColour(spectra, light); }
};

struct ColourAt {
    const Geometry& geometry;
    Work& work;

    Xyz operator()(PaletteColour& colour) const { return colour.at(geometry.incidence, work); }
    Xyz operator()(LayeredColour& colour) const { return colour.at(geometry.incidence, &work); }
    Xyz operator()(GratingColour& colour) const {
        ++work.spectra;
        work.samples += colour.samples();
        work_of(work.effects, Effect::higher_orders).points += colour.samples_of_higher_orders();
        return colour.at(geometry.grating_u);
    }
    Xyz operator()(ScatterColour& colour) const { return colour.at(geometry.cos_scatter, &work); }
    Xyz operator()(MeasuredColour& colour) const { return colour.at(geometry.incidence, &work); }
};

}  // namespace

Xyz PaletteColour::at(const Incidence& incidence, Work& work) {
    const Lobe lobe = curve_.at(incidence);
    const Light& light = *light_;
    if (light.settings.wavelengths) {
        ++work.spectra;
        work.samples += static_cast<std::uint64_t>(light.grid.count);
        Xyz sum;
        for (int node = 0; node < light.grid.count; ++node) {
            const double r = lobe_reflectance(lobe, light.grid.wavelength_nm(node));
            if (r == 0.0) continue;
            const auto i = static_cast<std::size_t>(node);
            sum.x += r * light.grid_weights.x[i];
            sum.y += r * light.grid_weights.y[i];
            sum.z += r * light.grid_weights.z[i];
        }
        return sum;
    }
    if (integral_ == Integral::fast) {
        ++work.fast_integrals;
        return lobe_to_xyz_fast(light.weights, light.moments, lobe.peak_nm, lobe.width_nm, lobe.height);
    }
    ++work.exact_integrals;
    return lobe_to_xyz(light.weights, lobe.peak_nm, lobe.width_nm, lobe.height);
}

PreparedColour prepare_colour(const Mechanism& mechanism, const SpectralSampling& sampling, const Light& light,
                              Integral integral) {
    return std::visit(Prepare{mechanism, sampling, light, integral}, static_cast<const MechanismModel&>(mechanism));
}

Xyz colour_at(PreparedColour& prepared, const Geometry& geometry, Work& work) {
    return std::visit(ColourAt{geometry, work}, prepared);
}

}  // namespace nacre
