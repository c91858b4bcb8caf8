#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/pick/band/exact_bands.h"
#include "nacre/pick/band/palette_bands.h"
#include "nacre/pick/band/shown_colour.h"
#include "reference/colour.h"
#include "reference/dice.h"
#include "reference/light.h"
#include "reference/lobe_integral.h"

/// What the tests of picked bands share: a light of the core beside the same light of the reference model, which
/// judges.
namespace nacre::test {

inline Light core_light(const std::string& illuminant) {
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.power = *illuminant_by_name(illuminant);
    return make_light(settings);
}

inline Xyz as_xyz(const reference::ModelXyz& colour) {
    return {colour.x, colour.y, colour.z};
}
inline reference::ModelXyz as_model(const Xyz& colour) {
    return {colour.x, colour.y, colour.z};
}

/// One illuminant, in the core and in the model.
struct PickLight {
    explicit PickLight(const std::string& illuminant)
        : core(core_light(illuminant)), bands(core), model(reference::ModelLight::of(illuminant, 2)), integral(model) {}

    Lobe only_band(const Xyz& colour) const { return palette_bands(bands, core, {{0.0, colour, {}}}).at(0); }

    /// The model's colour of a band, before adaptation.
    reference::Triple seen(const Lobe& lobe) const {
        const reference::Triple band = integral(lobe.peak_nm, lobe.width_nm, lobe.flatness), white = integral.white();
        reference::Triple sum{};
        for (std::size_t c = 0; c < 3; ++c) sum[c] = lobe.floor * white[c] + (lobe.height - lobe.floor) * band[c];
        return sum;
    }
    /// CIEDE2000 between a band and a colour, both by the model.
    double difference(const Lobe& lobe, const Xyz& colour) const {
        return reference::difference(model.adapted(seen(lobe)), as_model(colour), 1.0);
    }

    Light core;
    ExactBands bands;
    const reference::ModelLight& model;
    reference::LobeIntegral integral;
};

/// Whether a surface can have it.
inline bool is_a_reflectance(const Lobe& lobe) {
    return lobe.height >= 0.0 && lobe.height <= 1.0 && lobe.floor >= 0.0 && lobe.floor <= 1.0 && lobe.width_nm >= 0.0 &&
           lobe.flatness >= 0.0 && lobe.flatness <= 0.999 && std::isfinite(lobe.peak_nm);
}

inline std::string text_of(const Lobe& lobe) {
    char text[200];
    std::snprintf(text, sizeof text, "{peak %.6g width %.6g height %.6g floor %.6g flatness %.6g}", lobe.peak_nm,
                  lobe.width_nm, lobe.height, lobe.floor, lobe.flatness);
    return text;
}

/// Counts what fails and keeps the first few.
struct Failures {
    int count = 0;
    std::ostringstream first;

    void add(const std::string& text) {
        if (++count <= 5) first << "\n  " << text;
    }
};

inline reference::ModelRgb random_rgb(reference::Dice& dice) {
    const double r = dice.unit(), g = dice.unit(), b = dice.unit();
    return {r, g, b};
}

/// The whole sweep instead of every n-th case.
inline bool sweeps_all_picks() {
    const char* request = std::getenv("NACRE_PICK_SWEEP");
    return request != nullptr && std::string(request) == "1";
}

}  // namespace nacre::test
