// [light]: reads it, and checks what the readers of its keys cannot: that light and observer together have a white.
#include <memory>
#include <string>
#include <utility>

#include "nacre/base/names.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/light_reader.h"

namespace nacre {
namespace {

// Y of the perfect reflector is 1 if all wavelengths count. Chosen: a grid that catches less than half of it shows
// another light.
constexpr double least_white = 0.5;

// A grid may step over all the light there is, and a table of power may have a white that no eye adapts to.
void check_white(const Light& light, const Table& scene) {
    if (light.settings.wavelengths && !(light.white().y > least_white)) {
        scene.table("accuracy")
            ->fail_at("wavelengths", "wavelengths = " + std::to_string(*light.settings.wavelengths) +
                                         " get no light from illuminant " + in_quotes(light.settings.illuminant) +
                                         "; give more of them");
    }
    if (can_adapt_from(light.settings.adaptation, light.white())) return;
    const Table* table = scene.table("light");
    const std::string message = "the white of illuminant " + in_quotes(light.settings.illuminant) +
                                " cannot be adapted to D65; use adapt = \"none\", more wavelengths, or a broader "
                                "spectrum";
    table != nullptr ? table->fail_at("illuminant", message) : scene.fail_at("accuracy", message);
}

}  // namespace

std::shared_ptr<const Light> plan_light(const Table& scene, const AccuracySettings& accuracy,
                                        const CurveReader& read_curve) {
    std::shared_ptr<const Light> light;
    attempt(scene, scene.where(), [&] {
        const Table* table = scene.table("light");
        LightSettings settings = read_light(table, accuracy.wavelengths, read_curve);
        if (table != nullptr && !table->is_good()) return;
        light = std::make_shared<const Light>(make_light(std::move(settings)));
        if (scene.is_good()) check_white(*light, scene);
    });
    return light;
}

}  // namespace nacre
