#pragma once

#include "nacre/scene/plan.h"

namespace nacre {

/// The same job with one more effect left out, and nothing sampled for its sake.
Job without_effect(Job job, Effect effect);

}  // namespace nacre
