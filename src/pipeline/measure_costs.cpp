#include "pipeline/measure_costs.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/lut/job.h"

namespace nacre {
namespace {

// A time is the median of so many runs, or of what fits into so many seconds: sixty cases then take some ten seconds.
constexpr int most_runs = 51;
constexpr int fewest_runs = 3;
constexpr double seconds_per_case = 0.15;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median_seconds(const std::function<Image<Rgb>()>& make, const Execution& execution) {
    std::vector<double> seconds;
    const double begin = now();
    while (static_cast<int>(seconds.size()) < fewest_runs ||
           (static_cast<int>(seconds.size()) < most_runs && now() - begin < seconds_per_case)) {
        execution.may_stop();
        const double start = now();
        make();
        seconds.push_back(now() - start);
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
}

// Deciding on the size, and measuring what came out, of one of nacre's own choices.
double overhead_seconds(const CostCase& cost, const PlannedLut& lut, const Encoding& encoding,
                        const Execution& execution) {
    PlannedLut asked = lut;
    asked.request = {};
    asked.request.max_de00 = cost.bound;
    asked.job.light = cost.job.light;
    const double start = now();
    const ChosenLut chosen = choose_lut(asked, encoding, execution.step);
    const double decided = now();
    const Image<Rgb> stored = cost.make();
    const double made = now();
    measure(chosen.lut.job, stored, encoding, chosen.worst);
    return (decided - start) + (now() - made);
}

}  // namespace

std::vector<CostRow> measure_costs(const PlannedLut& lut, const Encoding& encoding, double bound,
                                   const Execution& execution) {
    std::vector<CostRow> rows;
    std::vector<CostCase> cases = cost_cases(lut, encoding, bound, execution.step);
    for (CostCase& cost : cases) {
        execution.may_stop();
        CostRow row;
        row.de00 = cost_error(cost, cost.make(), encoding, execution.step);
        row.seconds = median_seconds(cost.make, execution);
        row.all_seconds = row.seconds;
        if (cost.family == CostFamily::choice) row.all_seconds += overhead_seconds(cost, lut, encoding, execution);
        row.cost = std::move(cost);
        rows.push_back(std::move(row));
        execution.tell(rows.size(), cases.size());
    }
    return rows;
}

}  // namespace nacre
