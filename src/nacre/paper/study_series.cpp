#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "nacre/paper/study.h"

namespace nacre {
namespace {

// The outcomes of one way for the targets of one half.
std::vector<const UserOutcome*> outcomes_of(const std::vector<StudyRun>& runs, bool is_of_layers, std::size_t way) {
    std::vector<const UserOutcome*> outcomes;
    for (const StudyRun& run : runs) {
        if (run.is_of_layers == is_of_layers) outcomes.push_back(&run.outcomes[way]);
    }
    return outcomes;
}

// The value below which a share of the values lie: of 25, the 7th, the 13th and the 19th are the quartiles.
double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
}

double reached_after(const std::vector<const UserOutcome*>& outcomes, int moves) {
    const auto count = std::count_if(outcomes.begin(), outcomes.end(), [&](const UserOutcome* outcome) {
        return outcome->is_reached && outcome->moves() <= moves;
    });
    return static_cast<double>(count);
}

double median_difference_after(const std::vector<const UserOutcome*>& outcomes, int moves) {
    std::vector<double> differences;
    for (const UserOutcome* outcome : outcomes)
        differences.push_back(outcome->difference[static_cast<std::size_t>(std::min(moves, outcome->moves()))]);
    return quantile(std::move(differences), 0.5);
}

// NaN where the target of that rank was not reached.
double moves_quantile(const std::vector<const UserOutcome*>& outcomes, double share) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> moves;
    for (const UserOutcome* outcome : outcomes) moves.push_back(outcome->is_reached ? outcome->moves() : never);
    const double found = quantile(std::move(moves), share);
    return found == never ? std::numeric_limits<double>::quiet_NaN() : found;
}

}  // namespace

Series study_summary(const std::vector<StudyRun>& runs) {
    Series series{"study_summary",
                  "Moves to a target by targets (of_layers: 0 if picks made them, 1 if physical parameters did) and "
                  "way (1: picks, 2: physical "
                  "parameters): quartiles, nan where fewer targets were reached; de00: median of what was left",
                  {"of_layers", "way", "targets", "reached", "quartile", "median", "upper_quartile", "de00"},
                  {}};
    const UserHabits habits;
    for (const bool is_of_layers : {false, true}) {
        for (std::size_t way = 0; way < study_ways().size(); ++way) {
            const auto outcomes = outcomes_of(runs, is_of_layers, way);
            series.rows.push_back({is_of_layers ? 1.0 : 0.0, static_cast<double>(way + 1),
                                   static_cast<double>(outcomes.size()), reached_after(outcomes, habits.most_moves),
                                   moves_quantile(outcomes, 0.25), moves_quantile(outcomes, 0.5),
                                   moves_quantile(outcomes, 0.75),
                                   median_difference_after(outcomes, habits.most_moves)});
        }
    }
    return series;
}

Series study_curves(const std::vector<StudyRun>& runs) {
    Series series{"study_curves",
                  "Share of the targets reached, and median CIEDE2000 of the best picture so far, after so many moves; "
                  "picks_to_layers: by picks to the targets that physical parameters made",
                  {"moves"},
                  {}};
    const std::vector<StudyWay> ways = study_ways();
    for (const char* half : {"picks", "layers"}) {
        for (const StudyWay& way : ways) {
            for (const char* what : {"_share", "_de00"}) series.columns.push_back(way.name + "_to_" + half + what);
        }
    }
    for (int moves = 0; moves <= UserHabits().most_moves; ++moves) {
        std::vector<double> row{static_cast<double>(moves)};
        for (const bool is_of_layers : {false, true}) {
            for (std::size_t way = 0; way < ways.size(); ++way) {
                const auto outcomes = outcomes_of(runs, is_of_layers, way);
                row.push_back(reached_after(outcomes, moves) / static_cast<double>(outcomes.size()));
                row.push_back(median_difference_after(outcomes, moves));
            }
        }
        series.rows.push_back(std::move(row));
    }
    return series;
}

}  // namespace nacre
