// A LUT at one size and in one format, compared with its model at any points.
//
// In: a job with its size, and an encoding. The LUT is baked, converted and rounded once; errors are then found point
// by point: what a shader fetches from the rounded numbers (or from those before rounding) against the model's colour,
// both as XYZ. Where a curve of the model is given, texels and model come from it.
#include "nacre/accuracy/trial.h"

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/lut/formats.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace nacre {
namespace {

Lab lab_at(Xyz colour, double scale) {
    return to_lab({scale * colour.x, scale * colour.y, scale * colour.z}, d65_white);
}

// @param floor  smaller differences than this may come out as floor: most points are far from the worst, and the
//               Euclidean distance tells so at a fraction of the price
double difference_above(const Xyz& one, const Xyz& other, double scale, double floor) {
    const Lab a = lab_at(one, scale);
    const Lab b = lab_at(other, scale);
    const double l = a.l - b.l;
    const double da = a.a - b.a;
    const double db = a.b - b.b;
    const double bound2 = most_ciede2000_per_lab * most_ciede2000_per_lab * (l * l + da * da + db * db);
    return bound2 <= floor * floor ? floor : ciede2000(a, b);
}

// What a LUT is held against: the true integral, or the scene's own samples.
Job model_of(Job job, bool sampled) {
    return sampled ? std::move(job) : integrated_job(std::move(job), {1e-3, 0.0, 1e-3, 0.0});
}

Image<Xyz> texels_of(const ModelCurve& curve, int width) {
    Image<Xyz> texels(width, 1);
    for (int column = 0; column < width; ++column) texels.at(column, 0) = curve.at(coordinate_of_texel(column, width));
    return texels;
}

Image<Rgb> rounded(Image<Rgb> image, PixelFormat format, const Encoding& encoding) {
    for (Rgb& texel : image) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b})
            texel.*component = encoding.stored(texel.*component, format);
    }
    return image;
}

}  // namespace

double display_scale(const Image<Xyz>& texels) {
    double brightest = 0.0;
    for (const Xyz& texel : texels) brightest = std::max(brightest, texel.y);
    return display_scale(brightest);
}

double brightness_scale(const Image<Xyz>& texels, double black_scale) {
    const bool is_black =
        std::all_of(texels.begin(), texels.end(), [](const Xyz& texel) { return !(texel.y > black_luminance); });
    return is_black ? black_scale : display_scale(texels);
}

Trial::Trial(const Job& job, PixelFormat format, const Encoding& encoding, bool sampled_model, double scale,
             double black_scale, AfterRow after_step, const ModelCurve* curve, TexelsOfWidths* known)
    : job_(job),
      model_job_(model_of(job, sampled_model)),
      encoding_(encoding),
      after_step_(std::move(after_step)),
      scale_(scale),
      curve_(curve) {
    if (curve_ == nullptr) model_.emplace(model_job_);
    const Image<Xyz> texels = curve_ != nullptr ? texels_of(*curve_, job_.width) : baked_texels(known);
    exact_ = encoding.to_rgb(texels);
    if (scale_ == 0.0)
        scale_ = brightness_scale(encoding.keeps_colours ? texels : encoding.to_xyz(exact_), black_scale);
    stored_ = rounded(exact_, format, encoding);
}

Trial::Trial(const Job& job, Image<Rgb> stored, const Encoding& encoding, std::function<LutPoint(LutPoint)> fetch_at,
             AfterRow after_step)
    : job_(job),
      model_job_(model_of(job, false)),
      encoding_(encoding),
      after_step_(std::move(after_step)),
      exact_(stored),
      stored_(std::move(stored)),
      fetch_at_(std::move(fetch_at)),
      scale_(display_scale(encoding.keeps_colours ? bake(model_job_)
                                                  : encoding.to_xyz(encoding.to_rgb(bake(model_job_))))) {
    model_.emplace(model_job_);
}

Trial::Trial(const Job& job, Image<Rgb> stored, const Encoding& encoding, const ModelCurve& curve, double scale)
    : job_(job),
      model_job_(job),
      encoding_(encoding),
      exact_(stored),
      stored_(std::move(stored)),
      scale_(scale),
      curve_(&curve) {}

Image<Xyz> Trial::baked_texels(TexelsOfWidths* known) {
    if (known == nullptr) return bake(job_, after_step_, &work_);
    auto found = known->find(job_.width);
    if (found == known->end()) found = known->emplace(job_.width, bake(job_, after_step_, &work_)).first;
    return found->second;
}

Image<Xyz> Trial::model_at(std::span<const LutPoint> points) {
    Image<Xyz> model(static_cast<int>(points.size()), 1);
    std::transform(points.begin(), points.end(), model.begin(), [&](LutPoint point) {
        return curve_ != nullptr ? curve_->at(point.x) : model_->at(point.x, point.y);
    });
    return encoding_.keeps_colours ? model : encoding_.to_xyz(encoding_.to_rgb(model));
}

std::vector<double> Trial::errors(const Image<Rgb>& lut, std::span<const LutPoint> points, double floor) {
    Image<Rgb> fetched(static_cast<int>(points.size()), 1);
    std::transform(points.begin(), points.end(), fetched.begin(),
                   [&](LutPoint point) { return fetch(lut, fetch_at_ ? fetch_at_(point) : point); });
    const Image<Xyz> seen = encoding_.to_xyz(fetched);
    const Image<Xyz> model = model_at(points);
    work_.probes += points.size();
    if (after_step_) after_step_();
    std::vector<double> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(difference_above(seen.data()[i], model.data()[i], scale_, floor));
    return result;
}

std::vector<double> Trial::errors_at(std::span<const LutPoint> points, double floor) {
    return errors(stored_, points, floor);
}

std::vector<double> Trial::unrounded_errors_at(std::span<const LutPoint> points, double floor) {
    return errors(exact_, points, floor);
}

double Trial::storage_error() const {
    const Image<Xyz> seen = encoding_.to_xyz(stored_);
    const Image<Xyz> meant = encoding_.to_xyz(exact_);
    double largest = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double error = difference_above(seen.data()[i], meant.data()[i], scale_, largest);
        if (std::isnan(error)) return std::numeric_limits<double>::infinity();  // too large for the format
        largest = std::max(largest, error);
    }
    return largest;
}

Work Trial::work() const {
    Work sum = work_;
    if (model_) sum += model_->work();
    return sum;
}

}  // namespace nacre
