// The report on a LUT that was found: where its error comes from, and what stands in the way of a smaller one.
//
// In: the survey, which knows the errors that no size helps against, and the LUT that was found with its scan. The
// error of interpolation is that of the same LUT before its numbers were rounded to the format, at the middles of its
// cells, where a linear filter errs most if the curve is smooth, and at the worst points of the scan.
#include "nacre/accuracy/explain_lut.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "nacre/accuracy/limiting_factor.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

// Of large LUTs every n-th cell.
std::vector<LutPoint> cell_middles(const Job& job) {
    // Empirical: interpolation errs alike in neighbouring cells of a large LUT, and its worst points are known.
    constexpr int most_per_side = 64, most_in_1d = 512;
    const int columns = job.width - 1;
    const int rows = std::max(job.height - 1, 1);
    const int most_columns = job.y ? most_per_side : most_in_1d;
    const int column_step = (columns + most_columns - 1) / most_columns;
    const int row_step = (rows + most_per_side - 1) / most_per_side;
    std::vector<LutPoint> points;
    for (int row = 0; row < rows; row += row_step) {
        for (int column = 0; column < columns; column += column_step)
            points.push_back({(column + 0.5) / columns, job.y ? (row + 0.5) / rows : 0.0});
    }
    return points;
}

double interpolation_error(const FoundLut& found) {
    std::vector<LutPoint> points = cell_middles(found.trial->job());
    points.insert(points.end(), found.scan.worst.begin(), found.scan.worst.end());
    const std::vector<double> errors = found.trial->unrounded_errors_at(points);
    double largest = 0.0;
    for (const double error : errors) largest = std::max(largest, error);
    return largest;
}

// What becomes of colours that the space cannot hold, where no gamut rule takes care of them.
double lost_by_space(const LutSearch& search, const Job& job, Work& work) {
    if (!search.encoding.keeps_colours) return 0.0;
    Job sample = job;
    sample.width = survey_columns;
    sample.height = sample.y ? survey_rows : 1;
    const Image<Xyz> meant = bake(sample, search.after_step, &work);
    const Image<Xyz> held = search.encoding.to_xyz(search.encoding.to_rgb(meant));
    double lost = 0.0;
    for (std::size_t i = 0; i < meant.size(); ++i)
        lost = std::max(lost, difference_at(meant.data()[i], held.data()[i], search.survey.scale));
    return lost;
}

}  // namespace

ChosenLut explain_lut(const LutSearch& search, FoundLut found, Work work) {
    const LutSurvey& survey = search.survey;
    ChosenLut result;
    result.lut = survey.lut;
    result.lut.job.sampling.kept = nullptr;
    result.lut.job.width = found.candidate.width;
    result.lut.job.height = found.candidate.height;
    result.lut.format = found.candidate.format;
    const Job& job = result.lut.job;
    result.effects = survey.effects;
    result.predicted = survey.known;
    result.predicted.total = total_error(survey, found.scan.largest);
    result.predicted.storage = found.trial->storage_error();
    result.predicted.interpolation = interpolation_error(found);
    result.is_reached = found.is_reached;
    result.worst = std::move(found.scan.worst);
    result.from_model = found.scan.largest / share_found_by_scan(job);
    result.model_points = found.scan.points;
    result.curve = survey.curve;
    if (!result.is_reached) {
        const std::int64_t most = survey.is_2d() ? survey.effort.most_texels() : std::int64_t{widest_lut_size};
        const double lost = lost_by_space(search, job, work);
        const bool is_spent = !survey.curve && survey.effort.is_spent(work);
        result.limiting_factor = limiting_factor(result, SearchEnd{lost, is_spent, static_cast<int>(most), found.jump});
    }
    result.work = work;
    return result;
}

}  // namespace nacre
