#include "nacre/cost/cost_error.h"

#include <algorithm>
#include <optional>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/measure.h"
#include "nacre/accuracy/model_curve.h"
#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/survey.h"
#include "nacre/accuracy/trial.h"
#include "nacre/material/effects.h"

namespace nacre {
namespace {

// What a curve of the model may be off, CIEDE2000: as an error it is seen in no digit that is told.
constexpr double tolerance_of_curve = 1e-4;

// The model's colours along a 1D job, and how bright they are shown.
struct ModelColours {
    ModelCurve curve;
    double scale;
};

// Where every colour takes long: the scan asks for thousands. As when nacre decides, none if the curve itself took too
// long.
std::optional<ModelColours> model_colours(const Job& job, const AfterRow& after_step) {
    const bool is_expensive = samples_spectra(job.material.mechanism) || effects_in(job).has(Effect::tilt);
    if (job.y || !is_expensive) return std::nullopt;
    Job sample = job;
    sample.width = survey_columns;
    const double scale = display_scale(bake(sample));
    auto curve = ModelCurve::within(Effort(job).most_curve_colours(), job, tolerance_of_curve, scale, after_step);
    if (!curve) return std::nullopt;
    return ModelColours{std::move(*curve), scale};
}

Scan scan_of(const CostCase& cost, const Image<Rgb>& stored, const Encoding& encoding, const AfterRow& after_step) {
    if (!cost.fetch_at) {
        if (const std::optional<ModelColours> model = model_colours(cost.job, after_step)) {
            Trial trial(cost.job, stored, encoding, model->curve, model->scale);
            return scan_errors(trial);
        }
    }
    Trial trial(cost.job, stored, encoding, cost.fetch_at, after_step);
    return scan_errors(trial);
}

}  // namespace

double cost_error(const CostCase& cost, const Image<Rgb>& stored, const Encoding& encoding,
                  const AfterRow& after_step) {
    const Scan scan = scan_of(cost, stored, encoding, after_step);
    // As if nacre had chosen it.
    ChosenLut chosen;
    chosen.lut.job = cost.job;
    chosen.lut.request.max_de00 = cost.sampled_for;
    chosen.worst = scan.worst;
    chosen.from_model = scan.largest;
    chosen.model_points = scan.points;
    return measure(chosen, {}, stored, encoding).reached;
}

}  // namespace nacre
