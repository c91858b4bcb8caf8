#pragma once

#include <algorithm>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/optics/lobe.h"

namespace nacre {

/// Which way a band points: up from 0 to 1, or down from 1 to 0.
enum class BandKind { band, notch };

/// A band of height 1 on floor 0, or a notch of height 0 in floor 1, by the numbers that searches move in.
///
/// The width goes with the square of `spread`, so that bands next to the spectral locus are as far apart as others.
struct UnitBand {
    static constexpr double widest_nm = 1000.0;
    static constexpr double narrowest_spread = 0.01;  ///< a tenth of a nanometre: the locus itself

    double peak_nm = 0.0;
    double spread = 0.0;    ///< in [narrowest_spread, 1]
    double flatness = 0.0;  ///< in [0, largest_flatness]

    double width_nm() const { return widest_nm * spread * spread; }
};

/// Its colour under a light, before adaptation.
inline Xyz unit_band_to_xyz(const Light& light, BandKind kind, const UnitBand& band) {
    const Xyz up = band_to_xyz(light.weights, {band.peak_nm, band.width_nm(), band.flatness});
    if (kind == BandKind::band) return up;
    const Xyz& white = light.weights.white;
    return {white.x - up.x, white.y - up.y, white.z - up.z};
}

/// The unit band between two reflectances.
/// @param low,high  of floor and height of a band, of height and floor of a notch
inline Lobe lobe_between(BandKind kind, const UnitBand& band, double low, double high) {
    const bool is_band = kind == BandKind::band;
    return {band.peak_nm, band.width_nm(), is_band ? high : low, is_band ? low : high, band.flatness};
}

/// The nearest that a search may try.
inline UnitBand within_limits(const Light& light, const UnitBand& band) {
    return {std::clamp(band.peak_nm, static_cast<double>(light.weights.first_nm),
                       static_cast<double>(light.weights.last_nm)),
            std::clamp(band.spread, UnitBand::narrowest_spread, 1.0), std::clamp(band.flatness, 0.0, largest_flatness)};
}

}  // namespace nacre
