#include "pipeline/measure_costs.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/accuracy/survey.h"
#include "nacre/cost/cost_error.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// A time is the median of so many runs, or of what fits into so many seconds: sixty cases then take some ten seconds.
// Slow ones run three times, very slow ones once.
constexpr int most_runs = 51;
constexpr int fewest_runs = 3;
constexpr double seconds_per_time = 0.1;
constexpr double most_seconds_per_time = 0.5;

double median_seconds(const std::function<void()>& work, const Execution& execution) {
    std::vector<double> seconds;
    const double begin = thread_seconds();
    const auto has_time = [&] {
        const double spent = thread_seconds() - begin;
        const auto runs = static_cast<int>(seconds.size());
        return runs < fewest_runs ? spent < most_seconds_per_time : runs < most_runs && spent < seconds_per_time;
    };
    do {
        execution.may_stop();
        const double start = thread_seconds();
        work();
        seconds.push_back(thread_seconds() - start);
    } while (has_time());
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
}

class Stopwatch {
public:
    Stopwatch(const PlannedLut& lut, const Encoding& encoding, double bound, const Execution& execution)
        : lut_(lut), encoding_(encoding), execution_(execution) {
        lut_.request = {};
        lut_.request.max_de00 = bound;
        lut_.job.light = without_wavelengths(lut.job.light);
    }

    CostRow row(CostCase cost) {
        CostRow row;
        Image<Rgb> stored;
        row.computing_seconds = seconds_of([&] { stored = cost.make(); });
        if (cost.family == CostFamily::choice) {
            time_choice(cost.bound, row);
        } else {
            row.measuring_seconds =
                seconds_of([&] { row.de00 = cost_error(cost, stored, encoding_, execution_.step); });
            if (cost.needs_sampling) row.deciding_seconds = sampling_seconds();
        }
        row.cost = std::move(cost);
        return row;
    }

private:
    double seconds_of(const std::function<void()>& work) const { return median_seconds(work, execution_); }

    // What a job's bake saves whose sampling has the colours of facets.
    double facet_seconds(const Job& job) const {
        if (job.sampling.facets == nullptr) return 0.0;
        Job bare = job;
        bare.sampling.facets.reset();
        return std::max(seconds_of([&] { bake(bare); }) - seconds_of([&] { bake(job); }), 0.0);
    }

    // What the bake of one of nacre's own choices does beside computing.
    void time_choice(double bound, CostRow& row) const {
        PlannedLut asked = lut_;
        asked.request.max_de00 = bound;
        ChosenLut chosen;
        row.deciding_seconds = seconds_of([&] { chosen = choose_lut(asked, encoding_, execution_.step); });
        const Job& job = chosen.lut.job;
        row.deciding_seconds = std::max(row.deciding_seconds - facet_seconds(job), 0.0);
        const Image<Xyz> texels = bake(job);
        const Image<Rgb> stored = stored_lut(job, chosen.lut.format, encoding_);
        row.measuring_seconds = seconds_of([&] { row.de00 = measure(chosen, texels, stored, encoding_).reached; });
    }

    // Of nodes and of the points of other sums, as the cases have them; for all of them it is the same.
    double sampling_seconds() {
        if (sampling_seconds_ < 0.0) {
            LutSurvey survey;
            sampling_seconds_ = seconds_of([&] {
                Work work;
                survey = survey_lut(lut_, false, {}, execution_.step, work);
            });
            Job job = survey.lut.job;
            job.width = survey_columns;
            job.height = job.y ? 2 : 1;
            sampling_seconds_ = std::max(sampling_seconds_ - facet_seconds(job), 0.0);
        }
        return sampling_seconds_;
    }

    PlannedLut lut_;
    const Encoding& encoding_;
    const Execution& execution_;
    double sampling_seconds_ = -1.0;  // not known yet
};

}  // namespace

std::vector<CostRow> measure_costs(const PlannedLut& lut, const Encoding& encoding, double bound,
                                   const Execution& execution) {
    std::vector<CostRow> rows;
    std::vector<CostCase> cases = cost_cases(lut, encoding, bound, execution.step);
    Stopwatch stopwatch(lut, encoding, bound, execution);
    for (CostCase& cost : cases) {
        execution.may_stop();
        rows.push_back(stopwatch.row(std::move(cost)));
        execution.tell(rows.size(), cases.size());
    }
    return rows;
}

}  // namespace nacre
