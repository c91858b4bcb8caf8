#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nacre/lut/colour_space.h"
#include "nacre/paper/paper_figures.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

/// A figure of the paper: what it is drawn from, and how.
struct PaperFigure {
    std::string name;   ///< "figure8"
    std::string title;  ///< one line of Markdown
    std::string shows;  ///< Markdown
    std::vector<Series> data;
    std::string script;                   ///< gnuplot, writes <name>.png; empty: the swatches are the figure
    std::vector<PlannedSwatch> swatches;  ///< each is <name of the swatch>.png

    /// Files without a folder.
    std::vector<std::string> pictures() const;
    std::vector<std::string> files() const;
};

/// Figures 5, 7, 8, 9, 11, 12 and 14, the palettes beside exact stacks, the automatic user, `bands`, and `white`, which
/// has data only.
/// @param to_display  colours the curves of Figure 14
std::vector<PaperFigure> paper_figures(const ColourSpace& to_display, bool is_srgb);

/// Comment, header, one row per line, 17 digits: every double comes back.
std::string csv_text(const Series& series);

/// The folder's README: every figure, what it shows, and where its numbers are.
std::string figures_readme(const std::vector<PaperFigure>& figures);

}  // namespace nacre
