#pragma once

#include "nacre/lut/job.h"
#include "pipeline/decide.h"
#include "pipeline/execution.h"

namespace nacre {

/// Seconds that bake() of a job takes on this machine and one thread, from a few of its texels: what is prepared once
/// per material is timed apart from what every texel takes, so that each counts as in the whole LUT. A curve of facets'
/// colours that deciding has made is taken as given.
double seconds_of_texels(const Job& job);

/// Seconds that the curve of facets' colours took, if deciding has made one; else 0.
double seconds_of_facets(const Job& job);

/// Seconds that baking a chosen LUT will take: computed, converted, measured, encoded; not written.
///
/// The texels as above; measuring by how many colours of the reference it asks for, of which a few are timed.
double seconds_of_bake(const DecidedLut& lut, const Execution& execution);

}  // namespace nacre
