#include "nacre/colour/light.h"

#include <utility>

#include "nacre/colour/colour_types.h"

namespace nacre {

Light make_light(LightSettings settings) {
    Light light;
    light.settings = std::move(settings);
    const LightSettings& s = light.settings;
    light.weights = make_tristimulus_weights(s.observer, s.power, s.first_nm, s.last_nm);
    if (s.wavelengths) {
        light.grid = {static_cast<double>(s.first_nm), static_cast<double>(s.last_nm), *s.wavelengths};
        light.grid_weights = make_grid_weights(light.weights, light.grid);
    }
    light.adaptation = adaptation_matrix(s.adaptation, light.white(), d65_white);
    return light;
}

std::shared_ptr<const Light> without_wavelengths(const std::shared_ptr<const Light>& light) {
    if (!light->settings.wavelengths) return light;
    LightSettings settings = light->settings;
    settings.wavelengths.reset();
    return std::make_shared<const Light>(make_light(std::move(settings)));
}

}  // namespace nacre
