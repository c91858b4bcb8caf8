#pragma once

#include <optional>
#include <vector>

#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"

namespace nacre {

/// One palette choice: the lobe that is seen at one angle.
struct Pick {
    double angle_deg = 0.0;  ///< in [0, 90]
    Lobe lobe;
    friend bool operator==(const Pick&, const Pick&) = default;
};

/// The paper's material: a lobe that moves with the angle so that it passes through every pick.
///
/// Along Y(theta) = p cos^2(theta) + (1 - p) cos(theta) (Park & Tsuruno 3.2.5, p is `shape`) the peak, the width and
/// the height of two picks are straight lines: that is (3.2.8)-(3.2.13) without their division by the difference of the
/// peaks. Floor and flatness run in the same way. More picks: monotone cubic interpolation in Y (Fritsch & Carlson
/// 1980, harmonic-mean slopes of Fritsch & Butland 1984), and straight lines outside the outermost picks.
struct Palette {
    std::vector<Pick> picks;  ///< at least one, in any order; one alone is the same lobe at every angle
    double shape = default_shape;

    /// The p with which some straight line in (3.2.5) follows the Bragg law of solid chitin (n = 1.56) best over 0-90
    /// degrees: within 0.2 % of the peak at the normal. n = 1.25 needs 0.77 and n = 1.83 needs 0.92; layers with air
    /// need less.
    static constexpr double default_shape = 0.88;

    friend bool operator==(const Palette&, const Palette&) = default;
};

/// Closer angles count as one, because the slope between them would be meaningless.
inline constexpr double smallest_pick_distance_deg = 1e-9;

/// Y(a) - Y(b) without cancellation: cos a - cos b = -2 sin((a + b) / 2) sin((a - b) / 2).
double shape_difference(double shape, const Incidence& a, const Incidence& b);

/// A palette prepared for evaluation at many angles.
class PaletteCurve {
public:
    /// @pre picks at one angle are equal; others are `smallest_pick_distance_deg` or more apart
    explicit PaletteCurve(const Palette& palette);

    /// Becomes the curve of another palette; the memory is kept, so a palette may change with every texel.
    /// @pre as of the constructor
    void reset(const Palette& palette);

    /// The lobe at an angle: height and floor clamped to [0, 1], width to >= 0, flatness to [0, largest_flatness].
    Lobe at(const Incidence& incidence) const;
    /// The unclamped values of the formulas: beyond the picks each may leave its range.
    Lobe unclamped(const Incidence& incidence) const;

private:
    struct Node {
        Incidence at;
        Lobe lobe;
        double step = 0.0;  // Y of the next node less Y of this one
        Lobe slope;         // per unit of Y; unused for two picks
    };
    bool has_angles_of(const Palette& palette) const;
    void set_angles(const Palette& palette);
    void set_slopes();
    double difference_from(const Node& node, const Incidence& incidence) const;

    std::vector<Node> nodes_;
    double shape_ = 0.0;
};

/// PaletteCurve for one angle.
Lobe palette_lobe_unclamped(const Palette& palette, const Incidence& incidence);
Lobe palette_lobe(const Palette& palette, const Incidence& incidence);

/// The angles at which the clamping of a palette begins.
struct ClampBounds {
    std::optional<double> below_deg;  ///< angles smaller than this are clamped
    std::optional<double> above_deg;  ///< angles larger than this are clamped
};

/// Never between the picks, because the interpolation does not overshoot; so at most once on either side.
/// Accuracy: 1e-13 degrees (bisection to the last bits).
ClampBounds palette_clamp_bounds(const Palette& palette);

/// Angles at which a palette's lobe turns sharply, in no order: its picks, and wherever one of its numbers reaches the
/// end of its range beyond them. Accuracy of the latter: 1e-13 degrees.
std::vector<double> palette_bends_deg(const Palette& palette);

}  // namespace nacre
