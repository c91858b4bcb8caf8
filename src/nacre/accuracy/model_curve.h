#pragma once

#include <vector>

#include "nacre/bake/bake.h"
#include "nacre/bake/plan.h"

namespace nacre {

/// The colours along a 1D LUT of a film or stack, as polynomials between landmarks: what deciding on a LUT asks
/// thousands of times, where the solver needs microseconds to seconds for each answer.
///
/// Chebyshev interpolation on intervals that are halved until new points agree.
class ModelCurve {
public:
    /// @param job        a 1D job of a film or stack, with its sampling decided
    /// @param tolerance  CIEDE2000 at `scale` that the curve may be off at the points tried; elsewhere it is as good
    /// @param after_step  called now and then; what it throws ends the search
    ModelCurve(const Job& job, double tolerance, double scale, const AfterRow& after_step = {});

    /// XYZ relative to D65. @param x  coordinate on the job's axis, in [0, 1]
    Xyz at(double x) const;

    /// Of making it.
    const Work& work() const { return work_; }

private:
    struct Panel {
        double to;                      // from where the one before ends
        std::vector<Xyz> coefficients;  // of the Chebyshev polynomials
    };
    std::vector<Panel> panels_;
    Work work_;
};

}  // namespace nacre
