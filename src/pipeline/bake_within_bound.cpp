#include "pipeline/bake_within_bound.h"

#include <optional>
#include <utility>

#include "nacre/accuracy/choose_lut.h"

namespace nacre {
namespace {

bool misses_its_bound(const ChosenLut& chosen, const BakedLut& baked) {
    return chosen.lut.request.has_bound && baked.reached && *baked.reached > chosen.lut.request.max_de00;
}

}  // namespace

BakedLut bake_within_bound(DecidedLut& decided, const Execution& execution) {
    const int most_times = decided.asked->is_of_pair ? 0 : 3;
    const LoadedScene& scene = *decided.scene;
    const ColourSpace& space = decided.space();
    const Encoding encoding = lut_encoding(space, decided.asked->colour.gamut);
    const auto bake = [&](const ChosenLut& chosen) {
        return bake_lut(chosen, scene.plan, scene.source, space, execution.step);
    };
    BakedLut best = bake(decided.lut);
    ChosenLut chosen = decided.lut;
    std::optional<double> reached = best.reached;
    Care care;
    for (int times = 0; times < most_times && chosen.is_reached && misses_its_bound(chosen, best); ++times) {
        care = more_care(care, chosen, *reached);
        chosen = choose_lut(*decided.asked, encoding, execution.step, care);
        BakedLut again = bake(chosen);
        reached = again.reached;
        if (*again.reached >= *best.reached) continue;
        best = std::move(again);
        decided.lut = chosen;
    }
    return best;
}

}  // namespace nacre
