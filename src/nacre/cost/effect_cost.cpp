#include "nacre/cost/effect_cost.h"

#include "nacre/lut/job.h"
#include "nacre/material/effects.h"

namespace nacre {

Job without_effect(Job job, Effect effect) {
    job.without.insert(effect);
    job.sampling.facets.reset();
    if (effect == Effect::thickness_spread) job.sampling.thickness_samples = 1;
    if (effect == Effect::size_spread) job.sampling.radii = 1;
    if (effect == Effect::incoherent_layers)
        job.sampling.incoherent_layers.clear();  // they may be layers that are gone
    return job;
}

}  // namespace nacre
