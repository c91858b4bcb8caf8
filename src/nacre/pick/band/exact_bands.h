#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/pick/band/chromaticity_table.h"
#include "nacre/pick/band/colour_solid.h"
#include "nacre/pick/band/unit_bands.h"

namespace nacre {

/// The bands that have exactly a colour, under one light. Immutable once made, so that threads may share it.
///
/// With the lower of floor and height at 0, the brightest bands of a chromaticity are flat ones: the optimal colours of
/// Schrödinger and MacAdam, whose reflectance is 0 or 1 with two jumps. So every colour that a reflectance can have is
/// a band's (floor 0) or a notch's (height 0) of some flatness; other bands share the colour with them. Where the
/// spectral locus has a dent, a band differs from such a colour by up to CIEDE2000 0.0135 (observed).
class ExactBands {
public:
    /// A band between two reflectances, `low` in [0, high], `high` in [low, 1].
    struct Match {
        BandKind kind = BandKind::band;
        UnitBand band;
        double low = 0.0;
        double high = 0.0;

        Lobe lobe() const { return lobe_between(kind, band, low, high); }
    };

    /// Takes some 2 milliseconds. @param light  has to outlive this
    explicit ExactBands(const Light& light);

    /// Of all bands that have the colour: a band rather than a notch, with `low` in its darker part, the one with the
    /// least flatness, then the greatest width. Nothing if no reflectance (of flatness up to the largest) has it.
    /// @param colour  before adaptation
    std::optional<Match> find(const Xyz& colour, BandKind kind, double low) const;

    /// The largest share in [0, inf) of a colour that a reflectance has; 0 outside the spectral locus, and where it is
    /// less than ColourSolid::least_share.
    double brightest(const Xyz& colour) const;

private:
    // Half cosines of one chromaticity.
    struct Roots {
        std::array<UnitBand, 12> band;
        std::size_t count = 0;

        bool has(const UnitBand& other, double nm, double spread) const {
            return std::any_of(band.begin(), band.begin() + count, [&](const UnitBand& root) {
                return std::abs(root.peak_nm - other.peak_nm) < nm && std::abs(root.spread - other.spread) < spread;
            });
        }
    };

    // Of a colour.
    struct Nearest {
        BandKind kind;
        UnitBand band;
        double de00;
    };

    bool solve_chromaticity(BandKind kind, Uv target, UnitBand& band) const;
    bool solve_colour(BandKind kind, const Xyz& target, UnitBand& band) const;
    Roots half_cosine_roots(BandKind kind, const Xyz& target) const;
    Nearest nearest(const ColourSolid::Stretch& stretch, const Xyz& target, double share) const;
    UnitBand rectangle_of(const ColourSolid::Stretch& stretch) const;
    std::optional<UnitBand> flattest(BandKind kind, const Xyz& target) const;
    std::optional<UnitBand> least_flat(BandKind kind, const Xyz& target, const Roots& roots) const;
    UnitBand less_flat(BandKind kind, const Xyz& target, UnitBand flat) const;
    Xyz colour_of(BandKind kind, const UnitBand& band) const { return unit_band_to_xyz(light_, kind, band); }

    const Light& light_;
    ColourSolid solid_;
    std::array<ChromaticityTable, 2> half_cosines_;
};

}  // namespace nacre
