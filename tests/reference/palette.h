#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/optics/palette.h"
#include "reference/lobe_integral.h"
#include "reference/scene.h"

namespace nacre::reference {

/// The exact colour of a palette, without facets.
class PaletteModel {
public:
    /// @param y  `shape`, or `peak_nm`, `width_nm`, `height`, `floor`, `flatness` of all picks
    PaletteModel(const Palette& palette, const std::optional<ModelParameter>& y, const ModelLight& light);

    /// @param cosine  of the angle; @param y  coordinate of the second axis, in [0, 1]
    ModelXyz at(double cosine, double y) const;

private:
    Palette palette_;
    std::optional<ModelParameter> y_;
    std::vector<double> pick_cosines_;
    const ModelLight* light_;
    std::shared_ptr<const LobeIntegral> integral_;
};

/// The same colour in 50 digits, with adaptive Gauss-Kronrod quadrature: up to seconds for a wide lobe.
/// @pre the scene is of a palette
XyzNumbers palette_in_50_digits(const ModelScene& scene, double x, double y = 0.0);

}  // namespace nacre::reference
