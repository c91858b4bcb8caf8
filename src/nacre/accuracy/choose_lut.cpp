// The choice of a LUT, in four steps: a survey of the material, a search for the size and format, a look at whether the
// nodes of spectra do for the texels that were found, and a report. Each has a file of its own that says how:
// survey.cpp, find_lut.cpp, confirm_nodes.cpp and explain_lut.cpp. Where the nodes do not, the first two steps are
// taken again with more of them; and once or twice more where the bound is missed by so little that nodes or the curve
// may be at fault. Where the colour jumps nothing helps.
#include "nacre/accuracy/choose_lut.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "nacre/accuracy/confirm_nodes.h"
#include "nacre/accuracy/explain_lut.h"
#include "nacre/accuracy/find_lut.h"
#include "nacre/accuracy/survey.h"
#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

// Where errors cannot be known: what the scene requests, and else a usual size.
ChosenLut choose_without_errors(const PlannedLut& lut, const AfterRow& after_step) {
    if (lut.request.is_binding) {
        throw Error(
            "the colour space has no inverse to XYZ, so its errors cannot be measured; give [accuracy] size "
            "instead of a bound");
    }
    ChosenLut result;
    LutSurvey survey = survey_lut(lut, false, {}, after_step, result.work);
    result.lut = std::move(survey.lut);
    result.lut.job.sampling.kept = nullptr;
    result.effects = std::move(survey.effects);
    result.predicted = survey.known;
    result.is_reached = false;
    result.lut.job.width = lut.request.width.value_or(usual_lut_width);
    result.lut.job.height = lut.job.y ? lut.request.height.value_or(usual_lut_height) : 1;
    result.lut.format = lut.request.format.value_or(PixelFormat::half_float);
    return result;
}

// A LUT whose texels need more nodes is surveyed and searched for again: so often at most. The second time is nearly
// always the last, because what was found says how many nodes they need.
constexpr int most_rounds = 4;

// A curve that may have missed something is made once more, with so much of the error; chosen.
constexpr double finer_curve = 0.2;

NodeCounts twice(NodeCounts counts) {
    for (int& count : counts) count = std::min(2 * count, most_nodes);
    return counts;
}

// Whether a LUT misses its bound by so little that it may be the fault of the curve or of the nodes.
bool is_in_doubt(const LutSurvey& survey, const FoundLut& found) {
    constexpr double near = 1.25;  // chosen
    if (found.is_reached || found.jump || !survey.curve) return false;
    return judged_error(survey, found.scan.largest) < near * survey.lut.request.max_de00;
}

// Those of a confirmation, where they are more than the survey's.
void set_nodes(const LutSurvey& survey, const NodeCounts& counts, SpectralSampling& sampling) {
    if (counts == sampling.counts().nodes) return;
    for (std::size_t band = 0; band < counts.size(); ++band) sampling.nodes[band] = survey.nodes->of(counts[band]);
}

// More nodes; if there were more already, or the scene gives them, a finer curve. Returns whether that is new.
bool add_care(const LutSurvey& survey, Care& care) {
    const bool are_given = survey.lut.request.sampling.nodes.front() > 0;
    if (!are_given && care.least.nodes == NodeCounts{}) {
        care.least.nodes = twice(survey.lut.job.sampling.counts().nodes);
        return true;
    }
    if (care.share_of_curve < 1.0) return false;
    care.share_of_curve = finer_curve;
    return true;
}

// What nodes may err by for the bound to be kept: what the rest leaves, and in any case what probes were chosen with.
double room_for_nodes(const LutSurvey& survey, const FoundLut& found) {
    if (!found.is_reached || survey.spectrum_error != SpectrumError::beside_scan)
        return std::numeric_limits<double>::infinity();
    const double rest = judged_error(survey, found.scan.largest) - survey.known.spectrum;
    return std::max(scannable_bound(survey) - rest, tolerance_of_nodes(survey.lut.request.max_de00));
}

}  // namespace

ChosenLut choose_lut(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step, Care care) {
    if (!encoding.to_xyz) return choose_without_errors(lut, after_step);
    Work all;
    for (int round = 1;; ++round) {
        Work work;
        const LutSurvey survey = survey_lut(lut, true, care, after_step, work);
        TexelsOfWidths known;
        const LutSearch search{survey, encoding, after_step, &known};
        FoundLut found = find_lut(search, work);
        if (is_in_doubt(survey, found) && add_care(survey, care)) {
            all += work;
            continue;
        }
        ConfirmedNodes confirmed{survey.lut.job.sampling.counts().nodes};
        if (!found.jump)
            confirmed = confirm_nodes(survey, found.candidate, room_for_nodes(survey, found), after_step, work);
        all += work;
        if (!confirmed.were_wrong || round == most_rounds) {
            ChosenLut chosen = explain_lut(search, std::move(found), all);
            chosen.of_nodes = confirmed.error;
            set_nodes(survey, confirmed.counts, chosen.lut.job.sampling);
            return chosen;
        }
        care.least.nodes = confirmed.counts;
    }
}

Care more_care(const Care& care, const ChosenLut& chosen, double measured) {
    constexpr double strictest = 0.5;  // of what texels may err by, at once; chosen
    Care more;
    more.share_of_texels = care.share_of_texels * std::max(chosen.lut.request.max_de00 / measured, strictest);
    more.least = chosen.lut.job.sampling.counts();
    more.share_of_curve = finer_curve * care.share_of_curve;
    more.least.nodes = twice(more.least.nodes);
    for (int* count : {&more.least.base_directions, &more.least.radii, &more.least.slices}) *count *= 2;
    return more;
}

}  // namespace nacre
