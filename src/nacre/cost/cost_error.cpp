#include "nacre/cost/cost_error.h"

#include <memory>
#include <optional>
#include <utility>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/confirm_nodes.h"
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
    const bool is_expensive = samples_spectra(job.material.mechanism) || effects_in(job).has_any(facet_effects);
    if (job.y || !is_expensive) return std::nullopt;
    Job sample = job;
    sample.width = survey_columns;
    const double scale = display_scale(bake(sample));
    auto curve = ModelCurve::within(Effort(job).most_curve_colours(), job, tolerance_of_curve, scale, after_step);
    if (!curve) return std::nullopt;
    return ModelColours{std::move(*curve), scale};
}

// What twice as many nodes change of a texel.
double error_of_nodes(const CostCase& cost, const std::optional<ModelColours>& model, const AfterRow& after_step) {
    LutSurvey survey;
    survey.lut.job = cost.job;
    survey.lut.request.max_de00 = cost.sampled_for;
    survey.lut.request.sampling.nodes = cost.job.sampling.counts().nodes;  // these, and no more
    survey.nodes = std::make_shared<NodeMaker>(cost.job.light->weights);
    if (model) {
        survey.scale = model->scale;
        survey.curve = std::make_shared<const ModelCurve>(model->curve);
    }
    Work work;
    return confirm_nodes(survey, {cost.job.width, cost.job.height, PixelFormat::single_float}, cost.sampled_for,
                         after_step, work)
        .error;
}

}  // namespace

double cost_error(const CostCase& cost, const Image<Rgb>& stored, const Encoding& encoding,
                  const AfterRow& after_step) {
    const std::optional<ModelColours> model = cost.fetch_at ? std::nullopt : model_colours(cost.job, after_step);
    Trial trial = model ? Trial(cost.job, stored, encoding, model->curve, model->scale)
                        : Trial(cost.job, stored, encoding, cost.fetch_at, after_step);
    const Scan scan = scan_errors(trial);
    // As if nacre had chosen it.
    ChosenLut chosen;
    chosen.lut.job = cost.job;
    chosen.lut.request.max_de00 = cost.sampled_for;
    chosen.worst = scan.worst;
    chosen.from_model = scan.largest;
    chosen.model_points = scan.points;
    if (!cost.fetch_at) chosen.of_nodes = error_of_nodes(cost, model, after_step);
    return measure(chosen, {}, stored, encoding).reached;
}

}  // namespace nacre
