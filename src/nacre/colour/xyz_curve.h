#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// A colour that depends on one number in [0, 1], as polynomials: for colours that take microseconds to seconds to
/// compute and are needed thousands of times.
///
/// Chebyshev interpolation on intervals that are halved until new points agree.
class XyzCurve {
public:
    using Colour = std::function<Xyz(double)>;
    using Agrees = std::function<bool(const Xyz&, const Xyz&)>;

    XyzCurve() = default;
    /// @param borders  ascending, the first 0 and the last 1: where intervals begin; at least wherever the colour has a
    /// kink
    /// @param agrees   whether an interpolated colour is as good as the true one
    /// @param after_step  called once per interval that was tried; an exception from it ends the search
    XyzCurve(const Colour& colour, const std::vector<double>& borders, const Agrees& agrees,
             const std::function<void()>& after_step = {});
    /// The same, or none if more than `most_intervals` would have to be tried.
    static std::optional<XyzCurve> within(std::int64_t most_intervals, const Colour& colour,
                                          const std::vector<double>& borders, const Agrees& agrees,
                                          const std::function<void()>& after_step = {});
    /// What an interval asks for at most.
    static constexpr int colours_per_interval = 15;

    Xyz at(double x) const;
    /// Ascending, the first 0 and the last 1: between them it is a polynomial.
    std::vector<double> borders() const;
    bool is_made() const { return !panels_.empty(); }

private:
    // Returns false if it gave up.
    bool fit(std::int64_t most_intervals, const Colour& colour, const std::vector<double>& borders,
             const Agrees& agrees, const std::function<void()>& after_step);

    struct Panel {
        double to;                      // from where the one before ends
        std::vector<Xyz> coefficients;  // of the Chebyshev polynomials
    };
    std::vector<Panel> panels_;
};

/// Ascending, ends added, and without those that lie closer together than a curve resolves.
std::vector<double> curve_borders(std::vector<double> borders);

}  // namespace nacre
