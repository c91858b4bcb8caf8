#pragma once

#include <glm/mat3x3.hpp>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// A lobe of height 1 by what searches move in: the width goes with the square of `spread`, so that lobes next to the
/// spectrum's locus are as far apart as others.
struct LobePlace {
    static constexpr double widest_nm = 1000.0;
    static constexpr double narrowest_spread = 0.01;  ///< a tenth of a nanometre: the locus itself

    double peak_nm = 0.0;
    double spread = 0.0;  ///< in [narrowest_spread, 1]

    double width_nm() const { return widest_nm * spread * spread; }
};

/// Colours of lobes under one light, relative to D65.
class LobeColours {
public:
    /// @param weights,moments  the second made of the first; have to outlive this
    /// @param adaptation       what the weights' XYZ are multiplied with so as to be relative to D65
    LobeColours(const TristimulusWeights& weights, const LobeMoments& moments, const glm::dmat3& adaptation)
        : weights_(weights), moments_(moments), adaptation_(adaptation) {}

    Xyz exact(LobePlace place) const;
    /// Some 20 ns. Relative to its own luminance good to 1e-4, and exact where the fast integral would not be.
    Xyz fast(LobePlace place) const;
    /// The nearest place that a lobe may have.
    LobePlace clamped(LobePlace place) const;
    double first_nm() const { return weights_.first_nm; }
    double last_nm() const { return weights_.last_nm; }

private:
    const TristimulusWeights& weights_;
    const LobeMoments& moments_;
    glm::dmat3 adaptation_;
};

}  // namespace nacre
