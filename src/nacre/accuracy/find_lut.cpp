// The search for a LUT's size and format.
//
// In: a survey (sampling, brightness, limit of error, limit of effort). In this order:
//   1. A 2D LUT is looked at where its axes end: if the colour jumps there, no size helps, and it gets a usual
//      one.
//   2. Candidates are listed by bytes. In 2D, one side is tried alone along slices through the LUT first: no candidate
//      needs to be narrower than the narrowest that fits along a slice, which rules out most of them.
//   3. Each is baked and scanned, the cheapest first, until one errs by no more than the limit. Where one failed is
//      where the next is scanned first, so that those too small fail at once.
//   4. If none fits, or the effort is spent, the largest are tried in turn for the least error, and of those that are
//      equally good the smallest is taken.
// The effort is counted, not timed, so that every machine finds the same LUT; what the survey took counts too.
#include "nacre/accuracy/find_lut.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "nacre/colour/difference.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// Coordinates at which slices are laid through a 2D LUT (empirical).
constexpr std::array slice_coordinates{0.0, 0.25, 0.5, 0.75, 1.0};

// Points that are kept of failed candidates (empirical: older ones rule out nothing that newer ones do not).
constexpr std::size_t most_failures = 96;

// Texels of LUTs that are tried when the effort is spent: so few that the search ends soon (empirical).
constexpr std::int64_t fewest_when_spent = 1 << 11;
constexpr std::int64_t most_when_spent = 1 << 13;
// A larger one takes seconds, which is too long for a LUT that does not keep its bound.
constexpr std::int64_t most_for_the_best = 1 << 20;
// An error that is so little larger than another is as good.
constexpr double as_good = 1.05;

// On a curve of the colours a size costs next to nothing to try, whatever the curve took.
bool is_spent(const LutSearch& search, const Work& work) {
    return !search.survey.curve && search.survey.effort.is_spent(work);
}

std::shared_ptr<Trial> trial_of(const LutSearch& search, Job job, const Candidate& candidate, double scale,
                                const ModelCurve* curve, TexelsOfWidths* known) {
    job.width = candidate.width;
    job.height = candidate.height;
    const bool model_samples = search.survey.spectrum_error == SpectrumError::not_judged;
    return std::make_shared<Trial>(job, candidate.format, search.encoding, model_samples, scale, search.survey.scale,
                                   search.after_step, curve, known);
}

// A candidate, baked and ready to be compared with the model.
std::shared_ptr<Trial> try_candidate(const LutSearch& search, const Candidate& candidate) {
    const LutSurvey& survey = search.survey;
    return trial_of(search, survey.lut.job, candidate, 0.0, survey.curve.get(),
                    survey.is_2d() ? nullptr : search.known);
}

// The job along a line through a 2D LUT. @param at  the other coordinate
Job slice_of(const Job& job, bool is_along_x, double at) {
    const double x = is_along_x ? 0.0 : at;
    const double y = is_along_x ? at : 0.0;
    Job slice = job;
    slice.material.mechanism = mechanism_at(job, x, y);
    slice.fixed = geometry_at(job, x, y);
    if (!is_along_x) slice.x = *job.y;
    slice.y.reset();
    return slice;
}

// Whether the colour jumps near a point, or changes within a millionth of the finest texel by more than the bound.
//
// Of the texel around the point the part with the largest change is taken, and of that again. Colours may jump without
// jumping along any row or column: a film of no thickness reflects nothing, and the thinnest is a mirror at 90 degrees.
bool jumps_near(const LutSearch& search, LutPoint at) {
    constexpr int halvings = 20;
    // With the finest nodes for all angles: where bands of angles meet, colours differ by what coarser ones err by.
    Job job = search.survey.lut.job;
    job.sampling.nodes.fill(job.sampling.nodes.back());
    const double scale = search.survey.scale;
    Sampler sampler(job);
    const double texel = 1.0 / (job.y ? largest_lut_size : widest_lut_size);
    double left = std::max(at.x - texel, 0.0);
    double low = std::max(at.y - texel, 0.0);
    double width = std::min(at.x + texel, 1.0) - left;
    double height = job.y ? std::min(at.y + texel, 1.0) - low : 0.0;
    double change = 0.0;
    for (int i = 0; i < halvings; ++i) {
        width *= 0.5;
        height *= 0.5;
        std::array<std::array<Xyz, 3>, 3> colours;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                colours[row][column] = !job.y && row > 0 ? colours[0][column]
                                                         : sampler.at(left + static_cast<double>(column) * width,
                                                                      low + static_cast<double>(row) * height);
            }
        }
        std::size_t row_of_most = 0, column_of_most = 0;
        change = -1.0;
        for (std::size_t row = 0; row < 2; ++row) {
            for (std::size_t column = 0; column < 2; ++column) {
                const double here = std::max(difference_at(colours[row][column], colours[row + 1][column + 1], scale),
                                             difference_at(colours[row + 1][column], colours[row][column + 1], scale));
                if (here <= change) continue;
                change = here;
                row_of_most = row;
                column_of_most = column;
            }
        }
        left += static_cast<double>(column_of_most) * width;
        low += static_cast<double>(row_of_most) * height;
    }
    return change > search.survey.lut.request.max_de00;
}

// The least width that fits a slice, from `smallest` on.
int smallest_width(const LutSearch& search, const Job& slice, int smallest, Work& work) {
    std::vector<LutPoint> failed;
    for (int size = smallest; size < largest_lut_size && !is_spent(search, work); size *= 2) {
        const Candidate candidate{size, 1, PixelFormat::single_float};
        const std::shared_ptr<Trial> trial = trial_of(search, slice, candidate, search.survey.scale, nullptr, nullptr);
        const Scan scan = scan_errors(*trial, scan_limit(search.survey), failed);
        work += trial->work();
        if (scan.is_complete) return size;
        failed.insert(failed.begin(), scan.at);
    }
    return largest_lut_size;
}

// The least size of one side that fits along slices through a 2D LUT: what the other side cannot help.
int smallest_side(const LutSearch& search, bool is_along_x, Work& work) {
    int smallest = 2;
    for (const double at : slice_coordinates)
        smallest = smallest_width(search, slice_of(search.survey.lut.job, is_along_x, at), smallest, work);
    return smallest;
}

struct CandidateList {
    std::vector<Candidate> candidates;  // by bytes
    bool may_fit = true;                // false: they are only tried for the best there is
    std::optional<LutPoint> jump{};     // where no size helps
};

CandidateList list_candidates(const LutSearch& search, Work& work) {
    const AccuracyRequest& request = search.survey.lut.request;
    const bool is_2d = search.survey.is_2d();
    if (is_2d && request.has_bound) {
        for (const LutPoint corner : {LutPoint{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
            if (!jumps_near(search, corner)) continue;
            const Candidate usual{request.width.value_or(usual_lut_width), request.height.value_or(usual_lut_height),
                                  request.format.value_or(PixelFormat::half_float)};
            return {{usual}, false, corner};
        }
    }
    const int narrowest = is_2d && !request.width ? smallest_side(search, true, work) : 2;
    const int lowest = is_2d && !request.height ? smallest_side(search, false, work) : 2;
    if (is_spent(search, work))
        return {candidates_from(request, is_2d, 2, 2, fewest_when_spent, most_when_spent), false};
    const std::int64_t most = search.survey.effort.most_texels();
    std::vector<Candidate> candidates = candidates_from(request, is_2d, narrowest, lowest, 0, most);
    if (!candidates.empty()) return {std::move(candidates), true};
    // Not even the least is little enough: one of the large ones, whatever its shape, is the best there is.
    return {candidates_from(request, is_2d, 2, 2, most / 4, most), false};
}

// Where candidates failed, the last first.
void remember(std::vector<LutPoint>& failures, LutPoint point) {
    failures.insert(failures.begin(), point);
    if (failures.size() > most_failures) failures.pop_back();
}

// Step 3. @param failures  where candidates failed is added
std::optional<FoundLut> find_smallest(const LutSearch& search, const std::vector<Candidate>& candidates,
                                      std::vector<LutPoint>& failures, Work& work) {
    const LutSurvey& survey = search.survey;
    const bool is_judged = survey.lut.request.has_bound || candidates.size() > 1;
    const double limit = scan_limit(survey);
    const bool has_means = survey.known.spread > 0.0 || survey.known.quadrature > 0.0;
    for (const Candidate& candidate : candidates) {
        if (is_spent(search, work)) return std::nullopt;
        std::shared_ptr<Trial> trial = try_candidate(search, candidate);
        Scan scan = scan_errors(*trial, is_judged ? limit : unlimited, failures);
        work += trial->work();
        if (!scan.is_complete) {
            remember(failures, scan.at);
            continue;
        }
        // A mean may be too rough for any LUT.
        const bool is_reached =
            scan.largest <= limit && (!has_means || judged_error(survey, scan.largest) <= survey.lut.request.max_de00);
        return FoundLut{candidate, std::move(scan), std::move(trial), is_reached};
    }
    return std::nullopt;
}

// The largest first; where there is no time for all, long and narrow ones are the first to go without. On the default
// axis a LUT is best about twice as wide as it is high (empirical).
std::vector<Candidate> best_first(const std::vector<Candidate>& candidates, bool is_2d, bool is_spent) {
    std::vector<Candidate> ordered(candidates.rbegin(), candidates.rend());
    if (!is_spent || !is_2d) return ordered;
    const auto narrowness = [](const Candidate& candidate) {
        return std::abs(std::log2(candidate.width) - std::log2(candidate.height) - 1.0);
    };
    std::stable_sort(ordered.begin(), ordered.end(), [&](const Candidate& left, const Candidate& right) {
        return narrowness(left) < narrowness(right);
    });
    return ordered;
}

// Step 4: the least error there is; of sizes that are equally good the smallest.
FoundLut find_best(const LutSearch& search, const std::vector<Candidate>& candidates, std::vector<LutPoint> failures,
                   Work& work) {
    const LutSurvey& survey = search.survey;
    const auto is_quick = [&](const Candidate& candidate) {
        return candidate.texels() <= (is_spent(search, work) ? most_when_spent : most_for_the_best);
    };
    const bool any_is_quick = std::any_of(candidates.begin(), candidates.end(), is_quick);
    std::optional<FoundLut> best;
    double least = unlimited;
    for (const Candidate& candidate : best_first(candidates, survey.is_2d(), is_spent(search, work))) {
        if (any_is_quick && !is_quick(candidate)) continue;
        const bool is_of_same_size =
            best && best->candidate.width == candidate.width && best->candidate.height == candidate.height;
        if (best && survey.effort.is_far_beyond(work) && !is_of_same_size) break;
        std::shared_ptr<Trial> trial = try_candidate(search, candidate);
        const auto first = best ? std::span<const LutPoint>(failures) : std::span<const LutPoint>{};
        Scan scan = scan_errors(*trial, as_good * least, first);
        work += trial->work();
        if (!scan.is_complete) {
            remember(failures, scan.at);
            continue;
        }
        least = std::min(least, scan.largest);
        best = FoundLut{candidate, std::move(scan), std::move(trial), false};
    }
    assert(best);  // the first is scanned without a limit
    return std::move(*best);
}

}  // namespace

FoundLut find_lut(const LutSearch& search, Work& work) {
    const LutSurvey& survey = search.survey;
    const CandidateList list = list_candidates(search, work);
    std::vector<LutPoint> failures;
    if (list.may_fit) {
        if (std::optional<FoundLut> smallest = find_smallest(search, list.candidates, failures, work))
            return std::move(*smallest);
    }
    FoundLut best = find_best(search, list.candidates, std::move(failures), work);
    // What is left for texels may be so little that no candidate was taken as good, and the sum still fits.
    best.is_reached = judged_error(survey, best.scan.largest) <= scannable_bound(survey);
    best.jump = list.jump;
    if (!best.is_reached && !best.jump && jumps_near(search, best.scan.at)) best.jump = best.scan.at;
    return best;
}

}  // namespace nacre
