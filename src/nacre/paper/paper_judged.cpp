#include "nacre/paper/paper_judged.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/image.h"
#include "nacre/base/text.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"
#include "nacre/paper/paper.h"
#include "nacre/shade/band.h"
#include "nacre/shade/spectra.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

constexpr int degrees_count = 91;
// Half a cosine is above half its height in the middle two thirds of its width.
constexpr double half_height_share = 2.0 / 3.0;
// The colours of both specimens at their angles, with the flanks of the bands of the stacks.
constexpr int first_nm = 320;
constexpr int last_nm = 720;

constexpr const char* stack_columns[] = {"_nm",     "_error_nm",          "_half_height_width_nm",
                                         "_height", "_repicked_error_nm", "_Y",
                                         "_de00",   "_scaled_de00",       "_repicked_de00"};

// A stack's columns of judged_angles(), as rows.
std::vector<std::vector<double>> judge(const Specimen& specimen, const Stack& stack,
                                       const std::shared_ptr<const Light>& light,
                                       const std::vector<Xyz>& palette_colours) {
    const Palette own = repicked(specimen, stack);
    const PaletteCurve palette(specimen.palette);
    const PaletteCurve own_curve(own);
    const std::vector<Xyz> colours = colours_at_degrees(stack, light);
    const auto first_pick = static_cast<std::size_t>(std::lround(specimen.palette.picks.front().angle_deg));
    const double scale = palette_colours[first_pick].y / colours[first_pick].y;
    const std::vector<double> raw = differences(palette_colours, colours);
    const std::vector<double> scaled = differences(palette_colours, colours, scale);
    const std::vector<double> own_de00 = differences(colours_at_degrees(own, light), colours);
    std::vector<std::vector<double>> rows;
    for (const Incidence& incidence : whole_degrees()) {
        const std::size_t i = rows.size();
        std::vector<double> row{no_peak, no_peak, no_peak, no_peak, no_peak};
        if (const auto band = find_band(stack, incidence, bragg_peak_nm(stack, incidence))) {
            row = {band->peak_nm, palette.at(incidence).peak_nm - band->peak_nm, band->half_height_width_nm,
                   band->height, own_curve.at(incidence).peak_nm - band->peak_nm};
        }
        row.insert(row.end(), {colours[i].y, raw[i], scaled[i], own_de00[i]});
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string names_of(const std::vector<ExactStack>& stacks) {
    std::string names;
    for (const ExactStack& stack : stacks) names += (names.empty() ? "" : "; ") + stack.name + ": " + stack.title;
    return names;
}

}  // namespace

Palette repicked(const Specimen& specimen, const Stack& stack) {
    Palette palette = specimen.palette;
    for (auto& [angle_deg, lobe] : palette.picks) {
        const Incidence incidence = Incidence::from_degrees(angle_deg);
        const auto band = find_band(stack, incidence, bragg_peak_nm(stack, incidence));
        assert(band);
        lobe = {band->peak_nm, band->half_height_width_nm / half_height_share, band->height};
    }
    return palette;
}

std::vector<Xyz> colours_at_degrees(const Mechanism& mechanism, const std::shared_ptr<const Light>& light) {
    Job job;
    job.material.mechanism = mechanism;
    job.light = light;
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.name == "theta_deg") job.x = {&kind, {}, 0.0, 1.0};
    }
    job.width = degrees_count;
    // A hundredth of a just noticeable difference: errors of interest are above 1.
    constexpr double tolerance = 1e-2;
    const int samples = is_irregular(mechanism) ? band_thickness_samples : 0;
    job.sampling =
        choose_sampling(job, {tolerance, tolerance, tolerance, 0.0}, {.counts = {.thickness_samples = samples}})
            .sampling;
    const Image<Xyz> image = bake(job);
    std::vector<Xyz> colours;
    for (int i = 0; i < degrees_count; ++i) colours.push_back(image.at(i, 0));
    return colours;
}

std::vector<double> differences(const std::vector<Xyz>& some, const std::vector<Xyz>& others, double scale) {
    std::vector<double> result;
    for (std::size_t i = 0; i < some.size(); ++i) {
        const Xyz other{scale * others[i].x, scale * others[i].y, scale * others[i].z};
        result.push_back(difference_at(some[i], other, 1.0));
    }
    return result;
}

Series judged_spectra(const Specimen& specimen, const std::vector<ExactStack>& stacks) {
    Series series{"stacks_" + specimen.name + "_spectra",
                  "Reflectance (" + specimen.title + ") of the palette and of exact stacks, angle in degrees behind " +
                      "the name; " + names_of(stacks),
                  {"wavelength_nm"},
                  {}};
    std::vector<double> wavelengths_nm;
    for (int nm = first_nm; nm <= last_nm; ++nm) {
        wavelengths_nm.push_back(nm);
        series.rows.push_back({wavelengths_nm.back()});
    }
    const auto add = [&](const std::string& name, const Mechanism& mechanism, double angle_deg) {
        series.columns.push_back(name + "_" + number_text(angle_deg));
        const auto responses = responses_at(mechanism, Incidence::from_degrees(angle_deg), wavelengths_nm);
        for (std::size_t i = 0; i < responses.size(); ++i) series.rows[i].push_back(responses[i].reflectance());
    };
    for (const double angle_deg : specimen.angles_deg) {
        add("palette", specimen.palette, angle_deg);
        for (const ExactStack& stack : stacks) add(stack.name, stack.stack, angle_deg);
    }
    return series;
}

Series judged_angles(const Specimen& specimen, const std::vector<ExactStack>& stacks,
                     const std::shared_ptr<const Light>& light) {
    Series series{"stacks_" + specimen.name,
                  "Palette (" + specimen.title + ") against exact stacks: peak, error = palette less stack, width at " +
                      "half height, height, Y, CIEDE2000 as they are and with the stack scaled to the palette's Y at " +
                      "the first pick; repicked: a palette picked from the stack itself; nan: no such band; " +
                      names_of(stacks),
                  {"angle_deg", "palette_nm", "palette_half_height_width_nm", "palette_height", "palette_Y"},
                  {}};
    const PaletteCurve palette(specimen.palette);
    const std::vector<Xyz> colours = colours_at_degrees(specimen.palette, light);
    for (const Incidence& incidence : whole_degrees()) {
        const Lobe lobe = palette.at(incidence);
        series.rows.push_back({incidence.theta_deg, lobe.peak_nm, lobe.width_nm * half_height_share, lobe.height,
                               colours[series.rows.size()].y});
    }
    for (const ExactStack& stack : stacks) {
        for (const char* column : stack_columns) series.columns.push_back(stack.name + column);
        const auto numbers = judge(specimen, stack.stack, light, colours);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            series.rows[i].insert(series.rows[i].end(), numbers[i].begin(), numbers[i].end());
    }
    return series;
}

Series judged_table(const Specimen& specimen, const std::vector<ExactStack>& stacks, const Series& angles) {
    Series series{"stacks_" + specimen.name + "_table",
                  "Palette (" + specimen.title +
                      ") against exact stacks at the paper's angles; stack: 1 is the first of " + names_of(stacks),
                  {"stack", "angle_deg", "palette_nm", "palette_half_height_width_nm", "palette_height", "palette_Y"},
                  {}};
    for (const char* column : stack_columns) series.columns.push_back("exact" + std::string(column));
    const std::size_t of_palette = 5;
    const std::size_t of_stack = std::size(stack_columns);
    for (std::size_t k = 0; k < stacks.size(); ++k) {
        for (const double angle_deg : specimen.angles_deg) {
            const auto& row = angles.rows[static_cast<std::size_t>(std::lround(angle_deg))];
            std::vector<double> out{static_cast<double>(k + 1)};
            out.insert(out.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(of_palette));
            const auto begin = row.begin() + static_cast<std::ptrdiff_t>(of_palette + k * of_stack);
            out.insert(out.end(), begin, begin + static_cast<std::ptrdiff_t>(of_stack));
            series.rows.push_back(std::move(out));
        }
    }
    return series;
}

Series judged_summary(const Specimen& specimen, const std::vector<ExactStack>& stacks, const Series& angles) {
    Series series{"stacks_" + specimen.name + "_summary",
                  "Largest and mean errors (" + specimen.title + ") at the paper's angles (here), over 0-60 and over " +
                      "0-90 degrees where there is a band; stack: 1 is the first of " + names_of(stacks),
                  {"stack"},
                  {}};
    Series here = angles;
    std::erase_if(here.rows, [&](const auto& row) {
        return std::find(specimen.angles_deg.begin(), specimen.angles_deg.end(), row.front()) ==
               specimen.angles_deg.end();
    });
    for (const ExactStack& stack : stacks) {
        std::vector<double> row{static_cast<double>(series.rows.size() + 1)};
        for (const char* what : {"_error_nm", "_repicked_error_nm", "_de00", "_scaled_de00", "_repicked_de00"}) {
            const std::string column = stack.name + what;
            const std::string name = std::string(what).substr(1);
            if (series.rows.empty()) {
                for (const char* range : {"_here", "_0_60", "_0_90"})
                    for (const char* kind : {"largest_", "mean_"}) series.columns.push_back(kind + name + range);
            }
            row.insert(row.end(), {here.largest(column, 0.0, 90.0), here.mean(column, 0.0, 90.0),
                                   angles.largest(column, 0.0, 60.0), angles.mean(column, 0.0, 60.0),
                                   angles.largest(column, 0.0, 90.0), angles.mean(column, 0.0, 90.0)});
        }
        series.rows.push_back(std::move(row));
    }
    return series;
}

}  // namespace nacre
