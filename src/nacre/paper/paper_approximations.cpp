#include <cstddef>
#include <string>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"
#include "nacre/paper/paper.h"
#include "nacre/paper/paper_figures.h"
#include "nacre/paper/paper_stacks.h"
#include "nacre/shade/band.h"

namespace nacre {
namespace {

// Figure 7: what the equation was made for (cuticle, 1.56), and how it does with less and with more index.
constexpr double figure7_indices[] = {1.25, 1.56, 1.83};

// A straight line a + b t through points (t, value), least squares.
struct Line {
    double offset = 0.0;
    double slope = 0.0;
};

Line fit_line(const std::vector<double>& t, const std::vector<double>& value) {
    const auto count = static_cast<double>(t.size());
    double mean_t = 0.0;
    double mean_value = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        mean_t += t[i] / count;
        mean_value += value[i] / count;
    }
    double covariance = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        covariance += (t[i] - mean_t) * (value[i] - mean_value);
        variance += (t[i] - mean_t) * (t[i] - mean_t);
    }
    const double slope = covariance / variance;
    return {mean_value - slope * mean_t, slope};
}

// At every whole degree the peak of the stack whose Bragg law the picks imply.
std::vector<double> exact_peaks_nm(const Specimen& specimen) {
    const Stack stack = exact_stacks(specimen).front().stack;
    std::vector<double> peaks_nm;
    for (const Incidence& incidence : whole_degrees()) {
        const auto band = find_band(stack, incidence, bragg_peak_nm(stack, incidence));
        peaks_nm.push_back(band ? band->peak_nm : no_peak);
    }
    return peaks_nm;
}

}  // namespace

Series paper_figure7() {
    Series series{
        "figure7",
        "Figure 7: X_A = sqrt(n^2 - sin^2) / n, its straight line in cos^2 by (3.2.4), and line less X_A, for three n",
        {"angle_deg"},
        {}};
    for (const double index : figure7_indices) {
        for (const char* what : {"exact_", "line_", "error_"}) series.columns.push_back(what + number_text(index));
    }
    for (const Incidence& incidence : whole_degrees()) {
        std::vector<double> row{incidence.theta_deg};
        for (const double index : figure7_indices) {
            const double exact = path_factor(index, incidence) / index;
            const double line = path_factor_line(index, incidence) / index;
            row.insert(row.end(), {exact, line, line - exact});
        }
        series.rows.push_back(row);
    }
    return series;
}

Series paper_figure8(const Specimen& specimen) {
    Series series{
        "figure8_" + specimen.name,
        "Figure 8: peak (" + specimen.title +
            "): Bragg's law, (3.2.5) with p = " + number_text(specimen.palette.shape) +
            " through the picks and fitted to 0-90 degrees, (3.2.4) through the picks; errors against Bragg's law; "
            "peak of the exact stack behind it and errors against that, nan where it has none",
        {"angle_deg", "bragg_nm", "palette_nm", "palette_error_nm", "fitted_nm", "fitted_error_nm", "cos2_nm",
         "cos2_error_nm", "exact_nm", "bragg_exact_error_nm", "palette_exact_error_nm", "cos2_exact_error_nm"},
        {}};
    const PaletteCurve palette(specimen.palette);
    const PaletteCurve cos2({specimen.palette.picks, 1.0});
    const std::vector<double> exact_nm = exact_peaks_nm(specimen);
    const Incidence normal;
    std::vector<double> y;
    std::vector<double> bragg_nm;
    for (const Incidence& incidence : whole_degrees()) {
        y.push_back(shape_difference(specimen.palette.shape, incidence, normal));
        bragg_nm.push_back(bragg_peak_nm(specimen.stack, incidence));
    }
    const Line line = fit_line(y, bragg_nm);
    for (const Incidence& incidence : whole_degrees()) {
        const std::size_t i = series.rows.size();
        const double bragg = bragg_nm[i];
        const double exact = exact_nm[i];
        const double through_picks = palette.at(incidence).peak_nm;
        const double fitted = line.offset + line.slope * y[i];
        const double by_cos2 = cos2.at(incidence).peak_nm;
        series.rows.push_back({incidence.theta_deg, bragg, through_picks, through_picks - bragg, fitted, fitted - bragg,
                               by_cos2, by_cos2 - bragg, exact, bragg - exact, through_picks - exact, by_cos2 - exact});
    }
    return series;
}

}  // namespace nacre
