#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// A colour that depends on one number in [0, 1], as polynomials: for colours that take microseconds to seconds to
/// compute and are needed thousands of times.
///
/// Interpolation at Chebyshev's points, whose number is doubled until the new points lie on the polynomial of the old
/// ones; no colour is computed twice. Intervals where that does not converge are halved.
class XyzCurve {
public:
    using Colour = std::function<Xyz(double)>;
    /// How far an interpolated colour is from the true one, in units of what is allowed: up to 1 it is as good.
    using Difference = std::function<double(const Xyz& interpolated, const Xyz& meant)>;

    XyzCurve() = default;
    /// @param borders  ascending, the first 0 and the last 1: where intervals begin; at least wherever the colour has a
    /// kink
    /// @param after_step  called after every few colours; an exception from it ends the search
    XyzCurve(const Colour& colour, const std::vector<double>& borders, const Difference& difference,
             const std::function<void()>& after_step = {});
    /// The same, or none if about `most_colours` have been computed before it is made.
    static std::optional<XyzCurve> within(double most_colours, const Colour& colour, const std::vector<double>& borders,
                                          const Difference& difference, const std::function<void()>& after_step = {});

    Xyz at(double x) const;
    /// Ascending, the first 0 and the last 1: between them it is a polynomial.
    std::vector<double> borders() const;
    /// The same curve, its intervals divided evenly and its polynomials made anew of lower degree, which takes less
    /// time to evaluate. @param degree  of the new ones: one interval for so many degrees of the old ones
    XyzCurve in_pieces(std::size_t degree) const;
    bool is_made() const { return !panels_.empty(); }
    /// That were computed to make it.
    std::size_t colours() const { return colours_; }

private:
    struct Panel {
        double to;                      // from where the one before ends
        std::vector<Xyz> coefficients;  // of the Chebyshev polynomials
    };
    std::vector<Panel> panels_;
    std::size_t colours_ = 0;
};

/// Ascending, ends added, and without those that lie closer together than a curve resolves.
std::vector<double> curve_borders(std::vector<double> borders);

}  // namespace nacre
