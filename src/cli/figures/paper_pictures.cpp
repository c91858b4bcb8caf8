#include "cli/figures/paper_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "cli/figures/stack_pictures.h"
#include "cli/figures/study_pictures.h"
#include "nacre/base/text.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {

// Compiled in from src/cli/figures.
extern const std::string_view bands_gp;
extern const std::string_view figure5_gp;
extern const std::string_view figure7_gp;
extern const std::string_view figure8_gp;
extern const std::string_view figure9_gp;
extern const std::string_view figure14_gp;

namespace {

// Column display_rgb: 0xRRGGBB as one number, the colour that the swatches would show too.
Series with_display_colour(Series series, const ColourSpace& to_display, bool is_srgb) {
    const auto x =
        static_cast<std::size_t>(std::find(series.columns.begin(), series.columns.end(), "X") - series.columns.begin());
    const auto byte = [](double value) { return std::round(255.0 * std::clamp(value, 0.0, 1.0)); };
    series.columns.emplace_back("display_rgb");
    for (auto& row : series.rows) {
        const Xyz colour{row[x], row[x + 1], row[x + 2]};
        const Rgb shown = to_display.to_rgb(is_srgb ? fit_to_srgb(colour) : colour);
        row.push_back(65536.0 * byte(shown.r) + 256.0 * byte(shown.g) + byte(shown.b));
    }
    return series;
}

PlannedSwatch planned(const PaperFigure& figure, SwatchKind kind, const Specimen& specimen, const std::string& title,
                      const std::shared_ptr<const Light>& light) {
    PlannedSwatch swatch;
    swatch.name = figure.name + "_" + specimen.name;
    swatch.kind = kind;
    swatch.title = title;
    swatch.jobs = swatch_jobs(kind, {specimen.name, specimen.palette, {}}, light);
    return swatch;
}

PaperFigure figure5(const Specimen& morpho) {
    return {
        "figure5",
        "Figure 5: the reflectance lobe",
        "What one palette pick stands for: half a cosine, h cos(π(λ − λpeak)/w), with its three numbers. Drawn for the "
        "Morpho's first "
        "pick; the dots are 5 nm apart. The width counts from zero to zero; at half height the band is 2/3 as wide.",
        {paper_figure5(morpho.palette.picks.front())},
        std::string(figure5_gp),
        {}};
}

PaperFigure figure7() {
    const Series data = paper_figure7();
    const auto percent = [&](const char* column) {
        return fixed_text(100.0 * data.largest(column, 0.0, 90.0), 2) + " % (mean " +
               fixed_text(100.0 * data.mean(column, 0.0, 90.0), 2) + " %)";
    };
    return {"figure7",
            "Figure 7: how well a straight line in cos²θ follows X_A (3.2.4)",
            "X_A = √(n² − sin²θ), divided by n, for n = 1.25, 1.56 and 1.83, and the straight line in cos²θ through "
            "its ends. Largest error: " +
                percent("error_1.25") + ", " + percent("error_1.56") + " and " + percent("error_1.83") +
                " of X_A at the normal. A line moved up by half of that errs by half as much, and no straight line by "
                "less.",
            {data},
            std::string(figure7_gp),
            {}};
}

// "3.3 nm at most between 0 and 90 degrees, 0.3 nm between the picks; ..."
std::string figure8_errors(const Specimen& specimen, const Series& data) {
    const auto nm = [&](const char* column, double from, double to) {
        return fixed_text(data.largest(column, from, to), 2) + " nm";
    };
    const auto& picks = specimen.palette.picks;
    const double first = picks.front().angle_deg;
    const double last = picks.back().angle_deg;
    return "through the picks, as nacre bakes it, (3.2.5) with p = " + number_text(specimen.palette.shape) +
           " errs by " + nm("palette_error_nm", first, last) + " at most between the picks (" + number_text(first) +
           "–" + number_text(last) + "°) and by " + nm("palette_error_nm", 0.0, 90.0) +
           " over 0–90°; fitted to all angles by " + nm("fitted_error_nm", 0.0, 90.0) +
           "; (3.2.4), which is p = 1, by " + nm("cos2_error_nm", first, last) + " between the picks and " +
           nm("cos2_error_nm", 0.0, 90.0) +
           " over all. Against the peak of the exact stack behind that law, between "
           "the picks: Bragg's law errs by " +
           nm("bragg_exact_error_nm", first, last) + ", (3.2.5) by " + nm("palette_exact_error_nm", first, last) +
           ", (3.2.4) by " + nm("cos2_exact_error_nm", first, last) +
           "; over all angles at which that stack has a band: " + nm("bragg_exact_error_nm", 0.0, 90.0) + ", " +
           nm("palette_exact_error_nm", 0.0, 90.0) + ", " + nm("cos2_exact_error_nm", 0.0, 90.0);
}

PaperFigure figure8(const Specimen& morpho, const Specimen& beetle) {
    const Series of_morpho = paper_figure8(morpho);
    const Series of_beetle = paper_figure8(beetle);
    return {
        "figure8",
        "Figure 8: how well (3.2.5) follows Bragg's law, and a real stack",
        "Peak wavelength against the angle, and largest errors. Morpho, lamellae of n = 1.56, 94.1 nm, and 83.2 nm of "
        "air: " +
            figure8_errors(morpho, of_morpho) +
            ". Beetle, solid stack of n = 1.717: " + figure8_errors(beetle, of_beetle) +
            ". The stacks are what the picks imply, not measurements; air between the lamellae is why the Morpho "
            "needs a small p. The exact stacks are those two again, solved with all that light does between their "
            "faces: 10 films of n = 1.56 + 0.06i, and 16 layers of n = 1.767 and 1.667. Where contrast is small, "
            "Bragg's law "
            "needs no correction; films in air reflect so strongly that it is off by more than (3.2.5) adds to it. "
            "Around 57°, "
            "Brewster's angle of those films, only one polarisation is reflected, and the peak wanders over its flat "
            "top. Near grazing the surface alone reflects nearly everything, and no band is left to have a peak.",
        {of_morpho, of_beetle, paper_picks(morpho), paper_picks(beetle)},
        std::string(figure8_gp),
        {}};
}

PaperFigure figure9(const Specimen& morpho, const Specimen& beetle) {
    return {"figure9",
            "Figure 9: peak, width and height against the angle",
            "The three numbers of the lobe between the picks (squares) and, fainter, beyond them, by (3.2.8)–(3.2.13). "
            "Where the formulas ask for "
            "a height outside [0, 1], nacre clamps it; the dotted line is what they ask for.",
            {paper_figure9(morpho), paper_figure9(beetle), paper_picks(morpho), paper_picks(beetle)},
            std::string(figure9_gp),
            {}};
}

PaperFigure figure14(const Specimen& morpho, const Specimen& beetle, const Light& light, const ColourSpace& to_display,
                     bool is_srgb) {
    return {"figure14",
            "Figure 14: the derived reflectance spectra",
            "Reflectance at the paper's angles, each curve in the colour that it has under D65 on this display. "
            "The Morpho at 40° is nearly black, because the eye sees little at 395 nm.",
            {paper_figure14(morpho), paper_figure14(beetle),
             with_display_colour(paper_figure14_colours(morpho, light), to_display, is_srgb),
             with_display_colour(paper_figure14_colours(beetle, light), to_display, is_srgb)},
            std::string(figure14_gp),
            {}};
}

PaperFigure figure11(const Specimen& morpho, const Specimen& beetle, const std::shared_ptr<const Light>& light) {
    PaperFigure figure{
        "figure11",
        "Figure 11: the plane of peak wavelength and angle",
        "Where the user picks the peak: every colour that the material can have at an angle, width and height "
        "following the angle, "
        "and the path of the peak through the two squares. The data are a coarser grid of the same plane.",
        {paper_figure11(morpho, light), paper_figure11(beetle, light)},
        {},
        {}};
    for (const Specimen* specimen : {&morpho, &beetle}) {
        figure.swatches.push_back(
            planned(figure, SwatchKind::plane, *specimen, specimen->title + ": peak wavelength and angle", light));
    }
    return figure;
}

PaperFigure figure12(const Specimen& morpho, const Specimen& beetle, const std::shared_ptr<const Light>& light) {
    PaperFigure figure{
        "figure12",
        "Figure 12: the palettes of width and height",
        "Where the user picks how saturated and how bright: the colours of every width and height at each pick's peak.",
        {paper_figure12(morpho, light), paper_figure12(beetle, light)},
        {},
        {}};
    for (const Specimen* specimen : {&morpho, &beetle}) {
        figure.swatches.push_back(
            planned(figure, SwatchKind::palette, *specimen, specimen->title + ": width and height", light));
    }
    return figure;
}

PaperFigure bands() {
    return {
        "bands",
        "What floor and flatness add to the band",
        "The half cosine of Figure 5, the same band with a plateau, with a floor, and a notch, whose floor is above "
        "its height. The dashed line repeats the half cosine. Floor and flatness are nacre's, not the paper's.",
        {paper_bands(), paper_band_lobes()},
        std::string(bands_gp),
        {}};
}

PaperFigure white() {
    return {"white",
            "White by the appendix",
            "(A.1) has no illuminant and (A.2) is the matrix for D65, so the paper's white is not (1, 1, 1) but "
            "(1.205, 0.948, 0.909) in linear "
            "Rec.709. Scenes get it with `illuminant = \"E\"`, `adapt = \"none\"`, `range_nm = [380, 780]`; by default "
            "nacre adapts, and white is white.",
            {paper_white()},
            {},
            {}};
}

}  // namespace

std::vector<std::string> PaperFigure::pictures() const {
    if (!script.empty()) return {name + ".png"};
    std::vector<std::string> names;
    for (const PlannedSwatch& swatch : swatches) names.push_back(swatch.name + ".png");
    return names;
}

std::vector<std::string> PaperFigure::files() const {
    std::vector<std::string> names = pictures();
    if (!script.empty()) names.push_back(name + ".gp");
    for (const Series& series : data) names.push_back(series.name + ".csv");
    return names;
}

std::vector<PaperFigure> paper_figures(const ColourSpace& to_display, bool is_srgb) {
    const Specimen morpho = paper_morpho();
    const Specimen beetle = paper_beetle();
    const auto light = default_light();
    return {figure5(morpho),
            figure7(),
            figure8(morpho, beetle),
            figure9(morpho, beetle),
            figure11(morpho, beetle, light),
            figure12(morpho, beetle, light),
            figure14(morpho, beetle, *light, to_display, is_srgb),
            stacks_figure(morpho, light),
            stacks_figure(beetle, light),
            study_figure(),
            bands(),
            white()};
}

std::string csv_text(const Series& series) {
    std::string text = "# " + series.comment + "\n";
    for (const std::string& column : series.columns) text += (&column == &series.columns.front() ? "" : ",") + column;
    text += "\n";
    for (const auto& row : series.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            char digits[40];
            std::snprintf(digits, sizeof digits, i == 0 ? "%.17g" : ",%.17g", row[i]);
            text += digits;
        }
        text += "\n";
    }
    return text;
}

std::string figures_readme(const std::vector<PaperFigure>& figures) {
    std::string text =
        "# The paper's figures, by nacre\n\n"
        "Park & Tsuruno, *A Color Palette based Interface for Biological Iridescences Rendering*, J. ADADA 18(1), "
        "2014.\n\n"
        "These figures are reconstructed from the paper's equations and parameters by `nacre figures`; nothing is "
        "copied from its pictures, and "
        "their layout, ranges and colours are ours. Every number that is drawn lies beside its figure as CSV (17 "
        "digits); `gnuplot NAME.gp`, run in "
        "this folder, draws a plot again. Figures 11 and 12 are drawn by nacre itself, because they are colours.\n";
    for (const PaperFigure& figure : figures) {
        text += "\n## " + figure.title + "\n\n";
        for (const std::string& picture : figure.pictures()) text += "![" + figure.title + "](" + picture + ")\n";
        text += (figure.pictures().empty() ? "" : "\n") + figure.shows + "\n\nFiles:";
        for (const std::string& file : figure.files()) text += " [" + file + "](" + file + ")";
        text += "\n";
    }
    return text;
}

}  // namespace nacre
