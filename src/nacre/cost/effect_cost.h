#pragma once

#include "nacre/lut/job.h"
#include "nacre/material/effects.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// The same job with one more effect left out, and without the sampling for it.
Job without_effect(Job job, Effect effect);

}  // namespace nacre
