#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "reference/colour.h"
#include "reference/lut.h"
#include "reference/scene.h"

namespace nacre::reference {

/// A colour along x in [0, 1]: polynomials between points at which it was asked for, once for any number of LUTs.
class ModelCurve {
public:
    using Exact = std::function<ModelXyz(double x)>;

    /// @param bends  coordinates at which the colour has a kink or the root of one
    /// @param tolerance  CIEDE2000 by which half of a polynomial's points may miss the others
    ModelCurve(Exact exact, const std::vector<double>& bends, double tolerance);

    ModelXyz at(double x) const;
    ModelXyz exactly_at(double x) const { return exact_(x); }
    /// How often it was asked.
    std::size_t points() const { return points_; }

private:
    // Even in t, which has the slope 0 at either end of a part between bends: a root there is a straight line.
    struct Part {
        double from = 0.0, to = 1.0;
    };
    static constexpr std::size_t count = 17;
    struct Panel {
        Part part;
        double from_t = 0.0, to_t = 1.0;
        std::array<ModelXyz, count> colour;
    };
    void add_panels(const Part& part, double from_t, double to_t, double tolerance);
    ModelXyz ask(double x);

    Exact exact_;
    double scale_ = 1.0;
    std::size_t points_ = 0;
    std::vector<Panel> panels_;
};

/// The colour of a film or stack along x of its LUT, with base, spread and tilt. A fiftieth of the finest bound that is
/// asked for anywhere: what all points of a polynomial miss is less by far.
ModelCurve curve_of_layers(const ModelScene& scene, double tolerance = 4e-4);

struct Worst {
    double error = 0.0, x = 0.0;
    double by_curve = 0.0;  ///< the same between the points that were asked for
};

/// The largest error of a LUT with one row: densely along the curve, and where that is worst by the exact colour.
Worst worst_of(const Pixels& lut, const ModelCurve& curve);

}  // namespace nacre::reference
