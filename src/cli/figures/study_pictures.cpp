#include "cli/figures/study_pictures.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/paper/study.h"

namespace nacre {

// Compiled in from src/cli/figures.
extern const std::string_view study_gp;

namespace {

std::string study_table(const Series& summary) {
    const std::vector<StudyWay> ways = study_ways();
    std::string text =
        "| targets made by | user sets | reached | first quartile of moves | median | third quartile | median ΔE00 at "
        "the end |\n|---|---|--:|--:|--:|--:|--:|\n";
    for (const auto& row : summary.rows) {
        const auto moves = [](double value) { return std::isnan(value) ? "–" : fixed_text(value, 0); };
        const StudyWay& way = ways[row[1] == 1.0 ? 0 : 1];
        text += "| " + ways[row[0] == 0.0 ? 0 : 1].title + " | " + way.title + " | " + fixed_text(row[3], 0) + " of " +
                fixed_text(row[2], 0) + " | " + moves(row[4]) + " | " + moves(row[5]) + " | " + moves(row[6]) + " | " +
                fixed_text(row[7], 1) + " |\n";
    }
    return text;
}

}  // namespace

PaperFigure study_figure() {
    const std::vector<StudyRun> runs = study_runs();
    const Series summary = study_summary(runs);
    return {"study",
            "The question of Figure 18, put to an automatic user",
            "Figure 18 of the paper is about people. Here a program moves one slider at a time, a quarter of its "
            "length at first and half of the step when nothing helps, until the mean CIEDE2000 over 0, 5, …, 80° is "
            "below 2, or until no step helps or 400 moves are made, which counts as not reached. A dash means that "
            "too few targets were reached.\n\n" +
                study_table(summary),
            {summary, study_curves(runs)},
            std::string(study_gp),
            {}};
}

}  // namespace nacre
