// What has to be known of a LUT before sizes are tried.
//
// In: a planned LUT, whose bound is split between the parts of its error. In this order:
//   1. The sampling of spectra and sums, and the effects (choose_sampling.cpp), each within its share of the bound.
//   2. A small bake, which says how bright the LUT is shown: colour differences depend on it. The curve of step 4 says
//      it better.
//   3. If the scene requests `wavelengths`, the same bake by the true integral: the difference is the spectrum's
//   error.
//   4. In 1D, a curve of the colours, if they are expensive: a search asks for thousands of them. If the curve itself
//      would take too long there is none, and colours are computed one by one.
//
// The shares leave most of the bound to texels, whose number grows with what is lost: halving a share costs a few more
// nodes, while halving the rest costs 1.4 times the texels. They are empirical, and hold for the 200 and 300 random
// scenes of tests/cli/layered_accuracy_test.cpp and effects_accuracy_test.cpp.
#include "nacre/accuracy/survey.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/trial.h"

namespace nacre {
namespace {

// Nodes err by less with every one more, and need little; the mean of uneven thicknesses converges slowly.
constexpr double share_of_nodes = 0.08;
constexpr double share_of_spread = 0.3;
// Each of the other sums: directions below a base, radii, slices.
constexpr double share_of_quadrature = 0.04;
// The curve stands for the texels and for what they are compared with. What it is tested by is the polynomial before
// the last points were added, which errs by five times as much and more (empirical); what a LUT that was found with it
// errs by is measured without it.
constexpr double share_of_curve = 0.02;
constexpr double coarser_curve = 5.0;
// Enough for the brightness of a LUT whose curve says it better (empirical).
constexpr int columns_before_curve = 9;

// Of the bound, up to which sums and means make a LUT larger.
constexpr double most_share_of_quadrature = 0.25;
constexpr double most_share_of_spread = 0.5;

SpectrumError spectrum_error_of(const PlannedLut& lut) {
    if (lut.job.light->settings.wavelengths)
        return lut.request.has_bound ? SpectrumError::in_scan : SpectrumError::not_judged;
    return traits_of(lut.job.material.mechanism).is_closed_form ? SpectrumError::in_scan : SpectrumError::beside_scan;
}

// Step 1.
void choose_sampling_of(LutSurvey& survey, bool can_judge, const Care& care, const AfterRow& after_step, Work& work) {
    const AccuracyRequest& request = survey.lut.request;
    Job& job = survey.lut.job;
    job.without = request.without;
    const double bound = request.max_de00;
    const bool may_drop = request.may_drop_effects && request.has_bound && can_judge;
    SamplingTolerance tolerance = sampling_tolerance(bound);
    if (may_drop) tolerance.effects = share_of_effects * bound;
    ChosenSampling chosen = choose_sampling(job, tolerance, {request.sampling, care.least, survey.nodes}, after_step);
    job.sampling = std::move(chosen.sampling);
    job.without = chosen.without;
    survey.effects = std::move(chosen.effects);
    survey.known.spectrum = chosen.error;
    survey.known.spread = chosen.spread_error;
    survey.known.quadrature = chosen.quadrature_error;
    survey.known.effects = chosen.effects_error;
    work += chosen.work;
}

// What the scene's wavelengths err by. @param seen  the colours of `sample`
double error_of_wavelengths(const Image<Xyz>& truth, const Image<Xyz>& seen, double scale) {
    double largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        largest = std::max(largest, difference_at(truth.data()[i], seen.data()[i], scale));
    return largest;
}

double scale_of(const ModelCurve& curve) {
    Image<Xyz> colours(survey_columns, 1);
    for (int i = 0; i < survey_columns; ++i) colours.at(i, 0) = curve.at(coordinate_of_texel(i, survey_columns));
    return display_scale(colours);
}

// A palette is cheap, unless it has facets.
bool is_expensive(const Job& job) {
    const bool has_facets = effects_in(job).minus(job.without).has_any(facet_effects);
    return has_facets || !traits_of(job.material.mechanism).is_closed_form;
}

}  // namespace

double tolerance_of_nodes(double max_de00) {
    return share_of_nodes * max_de00;
}

SamplingTolerance sampling_tolerance(double max_de00) {
    return {tolerance_of_nodes(max_de00), share_of_spread * max_de00, share_of_quadrature * max_de00, 0.0};
}

LutSurvey survey_lut(const PlannedLut& lut, bool can_judge, const Care& care, const AfterRow& after_step, Work& work) {
    LutSurvey survey;
    survey.lut = lut;
    survey.share_of_texels = care.share_of_texels;
    survey.nodes = std::make_shared<NodeMaker>(lut.job.light->weights);
    survey.lut.job.sampling.kept = std::make_shared<KeptSolvers>();
    choose_sampling_of(survey, can_judge, care, after_step, work);
    if (!can_judge) return survey;
    const Job& job = survey.lut.job;
    const double bound = lut.request.max_de00;
    survey.spectrum_error = spectrum_error_of(survey.lut);
    survey.effort = Effort(job);
    const bool is_sampled = job.light->settings.wavelengths.has_value();
    const bool wants_curve = !is_sampled && !survey.is_2d() && is_expensive(job);
    Job sample = job;
    sample.width = wants_curve ? columns_before_curve : survey_columns;
    sample.height = survey.is_2d() ? survey_rows : 1;
    const Image<Xyz> colours = bake(sample, {}, &work);
    survey.scale = display_scale(colours);
    if (is_sampled) {
        const Image<Xyz> truth = bake(integrated_job(sample, sampling_tolerance(bound)), {}, &work);
        survey.scale = display_scale(truth);
        survey.known.spectrum = std::max(survey.known.spectrum, error_of_wavelengths(truth, colours, survey.scale));
    }
    if (wants_curve) {
        const double tolerance = care.share_of_curve * coarser_curve * share_of_curve * bound;
        std::optional<ModelCurve> curve =
            ModelCurve::within(survey.effort.most_curve_colours(), job, tolerance, survey.scale, after_step);
        if (!curve) return survey;
        survey.scale = scale_of(*curve);
        work += curve->work();
        survey.curve = std::make_shared<const ModelCurve>(std::move(*curve));
    }
    return survey;
}

double scannable_bound(const LutSurvey& survey) {
    return share_found_by_scan(survey.lut.job) * survey.lut.request.max_de00;
}

double scan_limit(const LutSurvey& survey) {
    const double bound = scannable_bound(survey);
    const ErrorSplit& known = survey.known;
    const double of_curve = survey.curve ? share_of_curve * survey.lut.request.max_de00 : 0.0;
    const double rest = bound - of_curve - known.effects - std::min(known.quadrature, most_share_of_quadrature * bound);
    if (survey.spectrum_error != SpectrumError::beside_scan) return survey.share_of_texels * rest;
    return survey.share_of_texels * (rest - known.spectrum - std::min(known.spread, most_share_of_spread * bound));
}

double total_error(const LutSurvey& survey, double scanned) {
    const ErrorSplit& known = survey.known;
    const double of_spectrum = survey.spectrum_error == SpectrumError::in_scan ? 0.0 : known.spectrum;
    return scanned + of_spectrum + known.spread + known.quadrature + known.effects;
}

double judged_error(const LutSurvey& survey, double scanned) {
    const bool is_judged = survey.spectrum_error != SpectrumError::not_judged;
    return total_error(survey, scanned) - (is_judged ? 0.0 : survey.known.spectrum);
}

}  // namespace nacre
