// From picked colours to a film or a stack, beside a table alone that takes longer. Colours of known designs, so that
// the best answer is no error at all: `error` is the mean CIEDE2000 of the answers, `worst` the largest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "io/ceres_solver.h"
#include "io/scene/scene_file.h"
#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/shown_colours.h"
#include "nacre/scene/plan.h"

namespace nacre::bench {
namespace {

struct Question {
    MechanismSearch search;
    std::shared_ptr<const Light> light;
};

// What a scene with two picks of this mechanism asks for.
Question question_of(const std::string& mechanism) {
    Question question;
    SceneFiles files = scene_files();
    files.find_mechanisms = [&](const MechanismSearch& search, const Light&) {
        question.search = search;
        FoundMechanism found;
        found.mechanism = search.start;
        found.values.resize(search.free.size());
        found.reached.resize(search.wanted.size());
        found.de00.resize(search.wanted.size());
        return std::vector<FoundMechanism>{found};
    };
    const std::string pick = "peak_nm = 500, width_nm = 100, height = 0.5 }";
    question.light =
        plan_scene(parse_scene("[material.m]\nmechanism = \"" + mechanism + "\"\npicks = [ { angle_deg = 10, " + pick +
                                   ", { angle_deg = 45, " + pick + " ]\n",
                               "bench"),
                   files)
            .light;
    return question;
}

// The colours of random designs.
std::vector<MechanismSearch> known_answers(const Question& question) {
    constexpr int count = 12;
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> unit;
    std::vector<MechanismSearch> searches;
    for (int i = 0; i < count; ++i) {
        MechanismSearch search = question.search;
        Mechanism mechanism = search.start;
        for (const FreeNumber& number : search.free) number.set(mechanism, number.at(unit(random)));
        std::vector<Geometry> places;
        for (const WantedColour& wanted : search.wanted) places.push_back(wanted.geometry);
        ShownColours shown(*question.light, places);
        std::vector<Xyz> colours(places.size());
        shown.at(mechanism, shown.sampling_for(mechanism, SearchDetail::report), colours);
        for (std::size_t pick = 0; pick < colours.size(); ++pick) search.wanted[pick].colour = colours[pick];
        searches.push_back(std::move(search));
    }
    return searches;
}

void find_all(benchmark::State& state, const std::string& mechanism, bool table_alone) {
    const Question question = question_of(mechanism);
    const std::vector<MechanismSearch> searches = known_answers(question);
    const LeastSquaresSolver solve = least_squares_solver();
    SearchEffort effort = effort_for(question.search);
    LeastSquaresSolver none = [](const LeastSquares&, std::span<double>, int) {};
    if (table_alone) effort = {1 << 17, 1, 1, 0, 1};
    double sum = 0.0;
    double worst = 0.0;
    for (auto _ : state) {
        sum = worst = 0.0;
        for (const MechanismSearch& search : searches) {
            const double error =
                find_mechanisms(search, *question.light, table_alone ? none : solve, effort).front().error;
            sum += error;
            worst = std::max(worst, error);
        }
    }
    const auto count = static_cast<double>(searches.size());
    state.counters["error"] = sum / count;
    state.counters["worst"] = worst;
    state.counters["per_pair"] = benchmark::Counter(count * static_cast<double>(state.iterations()),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void pick_film(benchmark::State& state) {
    find_all(state, "film", false);
}
void pick_film_by_table(benchmark::State& state) {
    find_all(state, "film", true);
}
void pick_stack(benchmark::State& state) {
    find_all(state, "stack", false);
}
void pick_stack_by_table(benchmark::State& state) {
    find_all(state, "stack", true);
}

BENCHMARK(pick_film)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_film_by_table)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_stack)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_stack_by_table)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre::bench
