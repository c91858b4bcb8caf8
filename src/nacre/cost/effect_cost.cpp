#include "nacre/cost/effect_cost.h"

#include "nacre/lut/job.h"
#include "nacre/material/effects.h"

namespace nacre {

Job without_effect(Job job, Effect effect) {
    job.without.insert(effect);
    job.sampling.facets.reset();
    if (effect == Effect::thickness_spread) job.sampling.realisations = 1;
    if (effect == Effect::size_spread) job.sampling.sizes = 1;
    if (effect == Effect::incoherent_layers) job.sampling.blurred.clear();  // they may be layers that are gone
    return job;
}

}  // namespace nacre
