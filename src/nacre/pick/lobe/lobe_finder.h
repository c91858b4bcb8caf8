#pragma once

#include <glm/mat3x3.hpp>

#include "nacre/base/least_squares.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/pick/lobe/lobe_colours.h"
#include "nacre/pick/lobe/lobe_roots.h"
#include "nacre/pick/lobe/nearest_downhill.h"
#include "nacre/pick/lobe/nearest_lobe.h"

namespace nacre {

/// Why no lobe has a colour.
enum class LobeMiss {
    none,       ///< one has: to `exact_lobe_de00`
    bright,     ///< lobes of its chromaticity are darker, even at height 1
    saturated,  ///< no lobe has its chromaticity: a purple, or more saturated than a band of any width
};

/// The lobe that was found for a colour.
struct LobeMatch {
    double peak_nm = 0.0;
    double width_nm = 0.0;
    double height = 0.0;
    double de00 = 0.0;  ///< between the colour and the lobe's own, both beside D65 white
    LobeMiss miss = LobeMiss::none;
};

/// Colours that are this near to a lobe's count as its own.
inline constexpr double exact_lobe_de00 = 0.01;

/// Finds the lobe whose colour is asked for: peak within the weights' range, width up to 1000 nm, height up to 1.
///
/// Of all lobes that have the colour's chromaticity and are not too bright the widest is taken, because it moves the
/// least (LobeRoots). Where none is, the nearest in CIEDE2000 (NearestLobe).
/// Deterministic; immutable once made, so that threads may share it. A colour that a lobe has takes some 2
/// microseconds, another some 120.
/// Accuracy of the nearest: of 100 000 random sRGB colours that no lobe has three were further than the best of an
/// exhaustive search by more than CIEDE2000 0.05, by 0.07 at most (tests/pipeline/lobe_finder_test.cpp looks at 10 000
/// of sRGB). Those bests lie where hues are opposite to within 0.0014 units of CIELAB: there CIEDE2000 jumps, rounding
/// decides what is seen, and answers keep away.
class LobeFinder {
public:
    /// Takes some milliseconds. @param weights,moments  have to outlive this
    /// @param adaptation  what the weights' XYZ are multiplied with so as to be relative to D65
    /// @param solve       brings bands that nearly have a colour to it, and others nearer; none: some colours next to
    /// the spectrum's locus then count as missed, by up to 1
    LobeFinder(const TristimulusWeights& weights, const LobeMoments& moments, const glm::dmat3& adaptation,
               LeastSquaresSolver solve);

    /// @param colour  relative to D65, Y = 1 for the perfect reflector; finite. Black has width 0
    LobeMatch find(Xyz colour) const;

private:
    LobeMatch match(const Lab& target, LobePlace place, double height) const;
    bool has_widest(const Xyz& colour, const Lab& target, LobeRoots::Found& roots, LobeMatch& widest) const;
    DimmedLobe exact_if_any(const Xyz& colour, const Lab& target, const LobeRoots::Found& roots,
                            const DimmedLobe& nearest) const;

    LobeColours colours_;
    LobeRoots roots_;
    NearestLobe nearest_;
    LeastSquaresSolver solve_;
};

}  // namespace nacre
