#include "nacre/paper/paper_figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
namespace {

std::string named(const Specimen& specimen) {
    return " (" + specimen.title + ")";
}

// Columns that say a colour: XYZ relative to D65, and linear Rec.709, in which it may be negative.
std::vector<std::string> with_colour(std::vector<std::string> columns) {
    columns.insert(columns.end(), {"X", "Y", "Z", "R", "G", "B"});
    return columns;
}

std::vector<double> with_colour(std::vector<double> row, Xyz colour) {
    const Rgb rgb = linear_rec709(colour);
    row.insert(row.end(), {colour.x, colour.y, colour.z, rgb.r, rgb.g, rgb.b});
    return row;
}

Material material(const Specimen& specimen) {
    return {specimen.name, specimen.palette, {}};
}

// Chosen: a band in the middle of the visible range, and what its floor and flatness make of it.
constexpr Lobe example_bands[] = {{550.0, 200.0, 0.8, 0.0, 0.0},
                                  {550.0, 200.0, 0.8, 0.0, 0.5},
                                  {550.0, 200.0, 0.8, 0.2, 0.0},
                                  {550.0, 200.0, 0.1, 0.7, 0.0}};

double coordinate(int i, int count) {
    return static_cast<double>(i) / (count - 1);
}

}  // namespace

std::size_t Series::index_of(const std::string& column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    assert(found != columns.end());
    return static_cast<std::size_t>(found - columns.begin());
}

double Series::value(double first, const std::string& column) const {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.front() == first; });
    assert(found != rows.end());
    return (*found)[index_of(column)];
}

std::vector<double> Series::magnitudes(const std::string& column, double from, double to) const {
    const std::size_t index = index_of(column);
    std::vector<double> result;
    for (const auto& row : rows) {
        if (row.front() >= from && row.front() <= to && !std::isnan(row[index])) result.push_back(std::abs(row[index]));
    }
    return result;
}

double Series::largest(const std::string& column, double from, double to) const {
    const std::vector<double> values = magnitudes(column, from, to);
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double Series::mean(const std::string& column, double from, double to) const {
    const std::vector<double> values = magnitudes(column, from, to);
    if (values.empty()) return 0.0;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Series paper_picks(const Specimen& specimen) {
    Series series{"picks_" + specimen.name,
                  "Section 5.1: palette picks" + named(specimen),
                  {"angle_deg", "peak_nm", "width_nm", "height"},
                  {}};
    for (const auto& [angle_deg, lobe] : specimen.palette.picks) {
        series.rows.push_back({angle_deg, lobe.peak_nm, lobe.width_nm, lobe.height});
    }
    return series;
}

Series paper_figure5(const Pick& pick) {
    const Lobe& lobe = pick.lobe;
    Series series{"figure5",
                  "Figure 5: reflectance h cos(pi (wavelength - peak) / w), 0 beyond half a width; peak = " +
                      number_text(lobe.peak_nm) + " nm, w = " + number_text(lobe.width_nm) +
                      " nm, h = " + number_text(lobe.height),
                  {"wavelength_nm", "reflectance"},
                  {}};
    constexpr double step_nm = 0.5;
    const int steps = static_cast<int>(std::ceil(lobe.width_nm / step_nm));
    for (int i = -steps; i <= steps; ++i) {
        const double wavelength_nm = lobe.peak_nm + i * step_nm;
        series.rows.push_back({wavelength_nm, lobe_reflectance(lobe, wavelength_nm)});
    }
    return series;
}

Series paper_figure9(const Specimen& specimen) {
    Series series{"figure9_" + specimen.name,
                  "Figure 9: lobe" + named(specimen) +
                      " against the angle, by (3.2.8)-(3.2.13), clamped and as the formulas have it",
                  {"angle_deg", "peak_nm", "width_nm", "height", "unclamped_width_nm", "unclamped_height"},
                  {}};
    const PaletteCurve curve(specimen.palette);
    std::vector<double> angles_deg;
    for (int half_degrees = 0; half_degrees <= 180; ++half_degrees) angles_deg.push_back(0.5 * half_degrees);
    const ClampBounds bounds = palette_clamp_bounds(specimen.palette);
    if (bounds.below_deg) angles_deg.push_back(*bounds.below_deg);
    if (bounds.above_deg) angles_deg.push_back(*bounds.above_deg);
    std::sort(angles_deg.begin(), angles_deg.end());
    for (const double angle_deg : angles_deg) {
        const Incidence incidence = Incidence::from_degrees(angle_deg);
        const Lobe lobe = curve.at(incidence);
        const Lobe raw = curve.unclamped(incidence);
        series.rows.push_back({angle_deg, lobe.peak_nm, lobe.width_nm, lobe.height, raw.width_nm, raw.height});
    }
    return series;
}

Series paper_figure11(const Specimen& specimen, const std::shared_ptr<const Light>& light) {
    constexpr int peaks = 41;   // 380 .. 780 nm by 10
    constexpr int angles = 37;  // 0 .. 90 degrees by 2.5
    Series series{
        "figure11_" + specimen.name,
        "Figure 11: colours of peak wavelength and angle" + named(specimen) + "; width and height follow the angle",
        with_colour({"peak_nm", "angle_deg"}),
        {}};
    const Job job = swatch_jobs(SwatchKind::plane, material(specimen), light).front();
    for (int j = 0; j < angles; ++j) {
        for (int i = 0; i < peaks; ++i) {
            const double x = coordinate(i, peaks);
            const double y = coordinate(j, angles);
            const double angle_deg = job.y->kind->geometry(y).incidence.theta_deg;
            series.rows.push_back(with_colour({job.x.parameter_value(x), angle_deg}, exact_xyz(job, x, y)));
        }
    }
    return series;
}

Series paper_figure12(const Specimen& specimen, const std::shared_ptr<const Light>& light) {
    constexpr int widths = 21;   // 0 .. 200 nm by 10
    constexpr int heights = 21;  // 0 .. 1 by 0.05
    Series series{"figure12_" + specimen.name,
                  "Figure 12: colours of width and height at each pick" + named(specimen),
                  with_colour({"angle_deg", "peak_nm", "width_nm", "height"}),
                  {}};
    const std::vector<Job> jobs = swatch_jobs(SwatchKind::palette, material(specimen), light);
    for (std::size_t pick = 0; pick < jobs.size(); ++pick) {
        const Job& job = jobs[pick];
        for (int j = 0; j < heights; ++j) {
            for (int i = 0; i < widths; ++i) {
                const double x = coordinate(i, widths);
                const double y = coordinate(j, heights);
                series.rows.push_back(
                    with_colour({job.fixed.incidence.theta_deg, specimen.palette.picks[pick].lobe.peak_nm,
                                 job.x.parameter_value(x), job.y->parameter_value(y)},
                                exact_xyz(job, x, y)));
            }
        }
    }
    return series;
}

Series paper_figure14(const Specimen& specimen) {
    Series series{"figure14_" + specimen.name,
                  "Figure 14: reflectance spectra" + named(specimen) + ", one column per angle in degrees",
                  {"wavelength_nm"},
                  {}};
    const PaletteCurve curve(specimen.palette);
    for (const double angle_deg : specimen.angles_deg) series.columns.push_back("R_" + number_text(angle_deg));
    for (int half_nm = 720; half_nm <= 1660; ++half_nm) {
        std::vector<double> row{0.5 * half_nm};
        for (const double angle_deg : specimen.angles_deg) {
            row.push_back(lobe_reflectance(curve.at(Incidence::from_degrees(angle_deg)), row.front()));
        }
        series.rows.push_back(row);
    }
    return series;
}

Series paper_figure14_colours(const Specimen& specimen, const Light& light) {
    Series series{"figure14_" + specimen.name + "_colours",
                  "Figure 14: lobe and colour of each spectrum" + named(specimen),
                  with_colour({"angle_deg", "peak_nm", "width_nm", "height"}),
                  {}};
    const PaletteCurve curve(specimen.palette);
    for (const double angle_deg : specimen.angles_deg) {
        const Incidence incidence = Incidence::from_degrees(angle_deg);
        const Lobe lobe = curve.at(incidence);
        const Xyz colour = adapt(light.adaptation, reflectance_xyz(specimen.palette, incidence, light));
        series.rows.push_back(with_colour({angle_deg, lobe.peak_nm, lobe.width_nm, lobe.height}, colour));
    }
    return series;
}

Series paper_bands() {
    Series series{"bands",
                  "Reflectance of four bands of a palette; their numbers are in bands_lobes.csv, in the same order",
                  {"wavelength_nm", "half_cosine", "flat", "with_floor", "notch"},
                  {}};
    for (int half_nm = 760; half_nm <= 1560; ++half_nm) {
        std::vector<double> row{0.5 * half_nm};
        for (const Lobe& lobe : example_bands) row.push_back(lobe_reflectance(lobe, row.front()));
        series.rows.push_back(row);
    }
    return series;
}

Series paper_band_lobes() {
    Series series{"bands_lobes",
                  "The four bands of bands.csv, one per row",
                  {"peak_nm", "width_nm", "height", "floor", "flatness"},
                  {}};
    for (const Lobe& lobe : example_bands) {
        series.rows.push_back({lobe.peak_nm, lobe.width_nm, lobe.height, lobe.floor, lobe.flatness});
    }
    return series;
}

Series paper_white() {
    LightSettings settings;
    settings.illuminant = "E";
    settings.power = *illuminant_by_name(settings.illuminant);
    settings.adaptation = Adaptation::none;
    settings.first_nm = 380;
    settings.last_nm = 780;
    return {"white",
            "The perfect reflector by (A.1) and (A.2): equal energy, 380-780 nm, no adaptation; R, G, B are "
            "(1.205, 0.948, 0.909) where X = Y = Z = 1, the CIE's tables have Z = 0.9999",
            with_colour({}),
            {with_colour({}, make_light(settings).white())}};
}

std::shared_ptr<const Light> default_light() {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    return std::make_shared<const Light>(make_light(std::move(settings)));
}

}  // namespace nacre
