// The choice of a LUT, in four steps: a survey of the material, a search for the size and format, a look at whether the
// nodes of spectra do for the texels that were found, and a report. Each has a file of its own that says how:
// survey.cpp, find_lut.cpp, confirm_nodes.cpp and explain_lut.cpp. Where the nodes do not, the first two steps are
// taken again with more of them. Where the colour jumps nothing helps.
#include "nacre/accuracy/choose_lut.h"

#include <algorithm>
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
        ConfirmedNodes confirmed{survey.lut.job.sampling.counts().nodes};
        if (!found.jump) confirmed = confirm_nodes(survey, found.candidate, after_step, work);
        all += work;
        if (confirmed.counts == survey.lut.job.sampling.counts().nodes || round == most_rounds) {
            ChosenLut chosen = explain_lut(search, std::move(found), all);
            chosen.of_nodes = confirmed.error;
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
    for (int& count : more.least.nodes) count = std::min(2 * count, most_nodes);
    for (int* count : {&more.least.base_directions, &more.least.radii, &more.least.slices}) *count *= 2;
    return more;
}

}  // namespace nacre
