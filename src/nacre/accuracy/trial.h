#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "nacre/accuracy/model_curve.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/sampler.h"

namespace nacre {

/// How many times brighter a LUT is shown so that its brightest texel has Y = 1: colour differences depend on it.
/// 1 for a LUT that is black all over.
double display_scale(const Image<Xyz>& texels);

/// The same, but what is given for a LUT that is black all over.
double brightness_scale(const Image<Xyz>& texels, double black_scale);

/// The colours of the texels of 1D LUTs of one job, by their width: both formats have them.
using TexelsOfWidths = std::map<int, Image<Xyz>>;

/// A LUT baked at one size, held against its model point by point.
class Trial {
public:
    /// Bakes it. `job` says the size and how spectra are integrated.
    /// @param sampled_model   whether the model samples spectra where the light says so; else it is the true integral
    /// @param scale           display_scale(); 0: the LUT's own
    /// @param black_scale     the scale of a LUT that is black all over, though its model may not be
    /// @param curve           of the same job, 1D: where both the LUT's and the model's colours are taken from; null:
    ///                        the job itself. Has to outlive the trial
    /// @param known           texels of the same job, to be taken or added; null: none
    /// @param after_step      called after every row and every batch of points; what it throws ends the trial
    Trial(const Job& job, PixelFormat format, const Encoding& encoding, bool sampled_model, double scale = 0.0,
          double black_scale = 1.0, AfterRow after_step = {}, const ModelCurve* curve = nullptr,
          TexelsOfWidths* known = nullptr);

    /// A LUT that came about in some other way.
    /// @param stored  job.width x job.height, as stored
    /// @param fetch_at  where a shader that means a point really fetches; empty: there
    Trial(const Job& job, Image<Rgb> stored, const Encoding& encoding, std::function<LutPoint(LutPoint)> fetch_at,
          AfterRow after_step = {});
    /// A finished LUT, held against the curve of its job's colours.
    Trial(const Job& job, Image<Rgb> stored, const Encoding& encoding, const ModelCurve& curve, double scale);
    // Its sampler refers to its job.
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// Error of what a shader fetches from the stored numbers, per point; those that cannot exceed `floor` may come out
    /// as `floor`.
    std::vector<double> errors_at(std::span<const LutPoint> points, double floor = 0.0);
    /// The same had the numbers not been rounded to a format.
    std::vector<double> unrounded_errors_at(std::span<const LutPoint> points, double floor = 0.0);
    /// What rounding alone does, at the texels.
    double storage_error() const;

    const Job& job() const { return job_; }
    double scale() const { return scale_; }
    const Image<Rgb>& stored() const { return stored_; }
    Work work() const;

private:
    std::vector<double> errors(const Image<Rgb>& lut, std::span<const LutPoint> points, double floor);
    Image<Xyz> baked_texels(TexelsOfWidths* known);
    Image<Xyz> model_at(std::span<const LutPoint> points);

    Job job_;
    Job model_job_;
    const Encoding& encoding_;
    AfterRow after_step_;
    Image<Rgb> exact_;   // components before they are rounded
    Image<Rgb> stored_;  // and after
    std::function<LutPoint(LutPoint)> fetch_at_;
    double scale_;
    const ModelCurve* curve_ = nullptr;
    std::optional<Sampler> model_;  // where there is no curve
    Work work_;
};

}  // namespace nacre
