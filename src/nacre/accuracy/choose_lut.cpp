// The choice of a LUT, in three steps: a survey of the material, a search for the size and format, and a report on what
// was found. Each has a file of its own that says how: survey.cpp, find_lut.cpp and explain_lut.cpp.
#include "nacre/accuracy/choose_lut.h"

#include <utility>

#include "nacre/accuracy/explain_lut.h"
#include "nacre/accuracy/find_lut.h"
#include "nacre/accuracy/survey.h"
#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

// Where errors cannot be known: what the scene requests, and else sizes that suit most materials.
ChosenLut choose_without_errors(const PlannedLut& lut, const AfterRow& after_step) {
    if (lut.request.is_binding) {
        throw Error(
            "the colour space has no inverse to XYZ, so its errors cannot be measured; give [accuracy] size "
            "instead of a bound");
    }
    constexpr int usual_width = 256;
    constexpr int usual_height = 64;
    ChosenLut result;
    LutSurvey survey = survey_lut(lut, false, after_step, result.work);
    result.lut = std::move(survey.lut);
    result.effects = std::move(survey.effects);
    result.predicted = survey.known;
    result.is_reached = false;
    result.lut.job.width = lut.request.width.value_or(usual_width);
    result.lut.job.height = lut.job.y ? lut.request.height.value_or(usual_height) : 1;
    result.lut.format = lut.request.format.value_or(PixelFormat::half_float);
    return result;
}

}  // namespace

ChosenLut choose_lut(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step) {
    if (!encoding.to_xyz) return choose_without_errors(lut, after_step);
    Work work;
    const LutSurvey survey = survey_lut(lut, true, after_step, work);
    TexelsOfWidths known;
    const LutSearch search{survey, encoding, after_step, &known};
    FoundLut found = find_lut(search, work);
    return explain_lut(search, std::move(found), work);
}

}  // namespace nacre
