#pragma once

#include <cstdint>
#include <optional>

#include "nacre/colour/xyz_curve.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// The colours along a 1D LUT: what deciding on a LUT asks thousands of times, where the model may need microseconds to
/// seconds for each answer.
class ModelCurve {
public:
    /// @param job        a 1D job, with its sampling decided
    /// @param tolerance  CIEDE2000 at `scale` that the curve may be off at the points tried; elsewhere it is as good
    /// @param after_step  called now and then; what it throws ends the search
    ModelCurve(const Job& job, double tolerance, double scale, const AfterRow& after_step = {});
    /// The same, or none if it could take more than `most_colours` of the model's.
    static std::optional<ModelCurve> within(double most_colours, const Job& job, double tolerance, double scale,
                                            const AfterRow& after_step = {});

    /// XYZ relative to D65. @param x  coordinate on the job's axis, in [0, 1]
    Xyz at(double x) const { return curve_.at(x); }

    /// Of making it.
    const Work& work() const { return work_; }

private:
    ModelCurve() = default;

    XyzCurve curve_;
    Work work_;
};

}  // namespace nacre
