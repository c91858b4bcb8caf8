#include "nacre/paper/study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "nacre/colour/spectral_nodes.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/prepared_colour.h"

namespace nacre {
namespace {

constexpr int last_degree = 80;
constexpr int degree_step = 5;
// Of the spectra of layers, and of uneven thicknesses: pictures of the targets are within CIEDE2000 0.9 of those with
// many more, and within 0.3 on average. Target and user have the same, so that both ways can reach 0.
constexpr int study_nodes = 32;
constexpr int study_thickness_samples = 64;
// As the Morpho of Osaka University has (paper_stacks.cpp).
constexpr int study_films = 6;
// The angles of the paper's Morpho.
constexpr double first_pick_deg = 0.0;
constexpr double second_pick_deg = 40.0;
// Of a slider's length at either end: there are no targets.
constexpr double margin = 0.1;
// A target has some colour at some angle: C*ab.
constexpr double least_chroma = 20.0;
// Bragg's law for layers with next to no solid in them, cos 40 degrees. With solids only the peak falls less.
constexpr double least_peak_ratio = 0.766;

Mechanism two_picks(const std::vector<double>& values) {
    return Palette{
        {{first_pick_deg, {values[0], values[1], values[2]}}, {second_pick_deg, {values[3], values[4], values[5]}}},
        Palette::default_shape};
}

Mechanism films_with_air(const std::vector<double>& values) {
    Layer film;
    film.index = values[2];
    film.thickness_nm = values[0];
    Layer air;
    air.index = 1.0;
    air.thickness_nm = values[1];
    Layer group;
    group.repeat = study_films - 1;
    group.layers = {film, air};
    Stack stack;
    stack.incident = 1.0;
    stack.layers = {group, film};
    stack.substrate = 1.0;
    stack.thickness_spread_nm = values[3];
    return stack;
}

// Positions of a random target. The peak of a palette falls with the angle, as it does in nature.
std::vector<double> random_positions(const StudyWay& way, bool is_of_layers, std::mt19937_64& dice) {
    const auto unit = [&] { return static_cast<double>(dice() >> 11U) * 0x1p-53; };
    std::vector<double> positions;
    for (std::size_t i = 0; i < way.sliders.size(); ++i) positions.push_back(std::lerp(margin, 1.0 - margin, unit()));
    if (is_of_layers) return positions;
    const auto& [name, from, to] = way.sliders.front();
    const double second_nm = std::lerp(from, to, positions[0]) * std::lerp(least_peak_ratio, 1.0, unit());
    positions[3] = std::max((second_nm - from) / (to - from), 0.0);
    return positions;
}

double largest_chroma(const StudyPicture& picture) {
    double largest = 0.0;
    for (const Lab& lab : picture) largest = std::max(largest, std::hypot(lab.a, lab.b));
    return largest;
}

}  // namespace

Mechanism StudyWay::at(const std::vector<double>& positions) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < sliders.size(); ++i)
        values.push_back(std::lerp(sliders[i].from, sliders[i].to, positions[i]));
    return material(values);
}

StudyWay picks_way() {
    return {"picks",
            "two picks",
            {{"peak at 0°", 380.0, 720.0},
             {"width at 0°", 20.0, 400.0},
             {"height at 0°", 0.0, 1.0},
             {"peak at 40°", 380.0, 720.0},
             {"width at 40°", 20.0, 400.0},
             {"height at 40°", 0.0, 1.0}},
            two_picks};
}

StudyWay layers_way() {
    return {"layers",
            "physical parameters",
            {{"film thickness", 40.0, 200.0},
             {"air thickness", 40.0, 200.0},
             {"index of the film", 1.3, 1.8},
             {"spread of thicknesses", 0.0, 20.0}},
            films_with_air};
}

std::vector<StudyWay> study_ways() {
    return {picks_way(), layers_way()};
}

StudyPainter::StudyPainter() : light_(default_light()) {
    const auto nodes = std::make_shared<const SpectralNodes>(make_spectral_nodes(light_->weights, study_nodes));
    sampling_.nodes.fill(nodes);
    sampling_.thickness_samples = study_thickness_samples;
}

StudyPicture StudyPainter::paint(const Mechanism& mechanism) const {
    PreparedColour prepared = prepare_colour(mechanism, sampling_, *light_);
    Work work;
    StudyPicture picture;
    for (int degrees = 0; degrees <= last_degree; degrees += degree_step) {
        const Xyz colour = colour_at(prepared, Incidence::from_degrees(degrees), work);
        picture.push_back(to_lab(colour, light_->white()));
    }
    return picture;
}

double picture_difference(const StudyPicture& one, const StudyPicture& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) sum += ciede2000(one[i], other[i]);
    return sum / static_cast<double>(one.size());
}

StudyTarget study_target(int number, const StudyPainter& painter) {
    std::mt19937_64 dice(static_cast<std::uint64_t>(number));
    StudyTarget target;
    target.is_of_layers = number % 2 == 1;
    const StudyWay way = target.is_of_layers ? layers_way() : picks_way();
    do {
        target.positions = random_positions(way, target.is_of_layers, dice);
        target.picture = painter.paint(way.at(target.positions));
    } while (largest_chroma(target.picture) < least_chroma);
    return target;
}

StudyRun study_run(int number, const StudyPainter& painter) {
    const StudyTarget target = study_target(number, painter);
    StudyRun run{target.is_of_layers, {}};
    for (const StudyWay& way : study_ways()) {
        const auto difference = [&](const std::vector<double>& positions) {
            return picture_difference(painter.paint(way.at(positions)), target.picture);
        };
        run.outcomes.push_back(move_sliders(way.start(), difference, study_goal));
    }
    return run;
}

std::vector<StudyRun> study_runs() {
    const StudyPainter painter;
    std::vector<StudyRun> runs;
    for (int number = 0; number < study_targets; ++number) runs.push_back(study_run(number, painter));
    return runs;
}

}  // namespace nacre
