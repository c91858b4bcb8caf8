#pragma once

#include <memory>
#include <optional>

#include "nacre/colour/light.h"
#include "nacre/pick/band/exact_bands.h"

namespace nacre {

/// The exact bands under the light of the last scene that asked for them: their tables take milliseconds, and the
/// variants of a scene share one light. Not to be used from several threads at once.
class KnownBands {
public:
    /// Valid until the next call.
    const ExactBands& under(const std::shared_ptr<const Light>& light) {
        if (!bands_ || !is_alike(*light_, *light)) {
            light_ = light;
            bands_.emplace(*light_);
        }
        return *bands_;
    }

private:
    static bool is_alike(const Light& a, const Light& b) {
        return a.weights.first_nm == b.weights.first_nm && a.weights.cells_per_nm == b.weights.cells_per_nm &&
               a.weights.x == b.weights.x && a.weights.y == b.weights.y && a.weights.z == b.weights.z &&
               a.adaptation == b.adaptation;
    }

    std::shared_ptr<const Light> light_;  // the bands refer to it
    std::optional<ExactBands> bands_;
};

}  // namespace nacre
