// What the whole plan shows: picks that no material meets, and materials that are hardly meant so.
#include <string>
#include <vector>

#include "nacre/pick/unmatched_picks.h"
#include "nacre/scene/plan_tables.h"
#include "nacre/scene/readers/mechanism_reader.h"

namespace nacre {
namespace {

std::string place_of(const SceneMaterial& material) {
    return material.where.text() + " [material." + material.name + "]: ";
}

}  // namespace

std::vector<Mistake> unmatched_pick_mistakes(const Plan& plan, bool if_given) {
    std::vector<Mistake> mistakes;
    for (const SceneMaterial& material : plan.materials) {
        for (const UnmatchedPick& unmatched : unmatched_picks(material.picked)) {
            const PickedColour& picked = unmatched.picked;
            if (!picked.is_searched && !if_given) continue;
            mistakes.push_back({picked.where, picked.where.text() + " [material." + material.name + "]: picks[" +
                                                  std::to_string(picked.pick) + "], " + picked.text + ": " +
                                                  unmatched.text});
        }
    }
    return mistakes;
}

std::vector<std::string> warnings_of(const Plan& plan) {
    // Of a material whose numbers are all given, who bakes it knows what it misses.
    std::vector<std::string> warnings;
    for (const Mistake& unmatched : unmatched_pick_mistakes(plan, false)) warnings.push_back(unmatched.text);
    for (const SceneMaterial& material : plan.materials) {
        const std::string warning = mechanism_warning(material.mechanism, plan.light->settings);
        if (!warning.empty()) warnings.push_back(place_of(material) + warning);
    }
    return warnings;
}

}  // namespace nacre
