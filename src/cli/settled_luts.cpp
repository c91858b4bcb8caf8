#include "cli/settled_luts.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

#include "cli/report.h"
#include "cli/stop_signal.h"
#include "cli/thread_clock.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

void override_accuracy(std::vector<LoadedScene>& scenes, double max_de00, const std::string& effects) {
    for (LoadedScene& scene : scenes) {
        for (PlannedLut& lut : scene.plan.luts) {
            if (!effects.empty()) lut.wish.may_drop_effects = effects == "auto";
            if (max_de00 > 0.0) {
                lut.wish.max_de00 = max_de00;
                lut.wish.has_bound = true;
                lut.wish.is_binding = true;
            }
            if (!lut.wish.is_binding || scene.transform.has_way_back()) continue;
            throw Error(
                lut.where.text() + " " + lut.name + ": space " + scene.transform.target() +
                " has no way back to XYZ, so no error can be measured in it; give [accuracy] size and no bound");
        }
    }
}

void settle_all(std::vector<SettledTask>& tasks, int threads, Console& console) {
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    std::atomic<std::size_t> done = 0;
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
            throw_if_stopped();
            SettledTask& task = tasks[i];
            const double begin = thread_seconds();
            try {
                const LoadedScene& scene = *task.scene;
                task.lut =
                    settle(*task.asked, lut_encoding(scene.transform, scene.plan.colour.gamut), throw_if_stopped);
            } catch (const IoError&) {
                throw;
            } catch (const Error& error) {
                task.failure = task.asked->where.text() + " " + task.asked->name + ": " + error.what();
            }
            task.seconds = thread_seconds() - begin;
            console.progress(++done, tasks.size());
        });
    });
    throw_if_stopped();
}

std::size_t report_out_of_reach(const std::vector<SettledTask>& tasks, bool best_effort, Console& console) {
    std::size_t count = 0;
    for (const SettledTask& task : tasks) {
        const AccuracyWish& wish = task.lut.lut.wish;
        if (!task.failure.empty() || task.lut.is_reached || !wish.has_bound) continue;
        if (!task.scene->transform.has_way_back()) continue;  // nobody knows
        const bool is_error = wish.is_binding && !best_effort;
        is_error ? console.error(out_of_reach(task.lut)) : console.warning(out_of_reach(task.lut));
        count += is_error ? 1 : 0;
    }
    return count;
}

namespace {

// CLI11's own range lets what is not a number pass.
const CLI::Validator is_bound(
    [](std::string& text) -> std::string {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= allowed_max_de00.low && value <= allowed_max_de00.high)
            return {};
        return "is out of range; allowed [" + number_text(allowed_max_de00.low) + ", " +
               number_text(allowed_max_de00.high) + "]";
    },
    "", "bound");

}  // namespace

void add_accuracy_option(CLI::App& app, double& value) {
    app.add_option("--accuracy", value, "largest colour error, CIEDE2000; wins over the scene's max_de00 (default 0.1)")
        ->type_name("DE")
        ->check(is_bound);
}

void add_strict_option(CLI::App& app, bool& is_strict) {
    app.add_flag("--strict", is_strict, "a picked colour that cannot be had is an error, not a warning");
}

void add_effects_option(CLI::App& app, std::string& word) {
    app.add_option(
           "--effects", word,
           "auto: leave out effects that change no colour by more than their share of the bound (default); all: "
           "simulate whatever the scene names")
        ->type_name("auto|all")
        ->check(CLI::IsMember({"auto", "all"}));
}

}  // namespace nacre
