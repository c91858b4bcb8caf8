#pragma once

#include <memory>
#include <optional>
#include <string>

#include <glm/mat3x3.hpp>

#include "nacre/base/sampled_curve.h"
#include "nacre/base/spectrum.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/observer.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// What [light] and [accuracy] say about how a spectrum becomes XYZ.
struct LightSettings {
    std::string illuminant = "D65";  ///< a CIE name, or the file name of a table
    SampledCurve power;              ///< the illuminant's relative spectral power
    bool is_table = false;           ///< whether the power came with the scene rather than from the CIE
    Observer observer = Observer::cie1931_2deg;
    Adaptation adaptation = Adaptation::bradford;
    int first_nm = 360;
    int last_nm = 830;
    std::optional<int> wavelengths;  ///< sample spectra at so many nodes; unset: exact integration
};

/// The same, ready to be multiplied with.
struct Light {
    LightSettings settings;
    TristimulusWeights weights;
    WavelengthGrid grid;       ///< only used if settings.wavelengths is set
    GridWeights grid_weights;  ///< likewise
    glm::dmat3 adaptation{1.0};

    /// What the perfect reflector has before adaptation.
    Xyz white() const { return settings.wavelengths ? grid_weights.white : weights.white; }
};

/// @pre the settings were checked when they were read
Light make_light(LightSettings settings);

/// The same light with exact integration; itself if it has that already.
std::shared_ptr<const Light> without_wavelengths(const std::shared_ptr<const Light>& light);

}  // namespace nacre
