#include "nacre/shade/palette_colour.h"

#include <cstddef>
#include <cstdint>

#include "nacre/colour/tristimulus.h"

namespace nacre {

Xyz lobe_to_xyz(const Light& light, const Lobe& lobe) {
    const Xyz band = band_to_xyz(light.weights, {lobe.peak_nm, lobe.width_nm, lobe.flatness});
    const double rise = lobe.height - lobe.floor;
    const Xyz& white = light.weights.white;
    return {lobe.floor * white.x + rise * band.x, lobe.floor * white.y + rise * band.y,
            lobe.floor * white.z + rise * band.z};
}

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
    ++work.exact_integrals;
    return lobe_to_xyz(light, lobe);
}

}  // namespace nacre
