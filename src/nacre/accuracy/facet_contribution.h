#pragma once

#include "nacre/accuracy/probes.h"
#include "nacre/colour/xyz_curve.h"
#include "nacre/material/effects.h"

namespace nacre {

/// What the facets of a tilted or rough surface change: CIEDE2000 at the scale of the brightest probe. Means over
/// facets are cheap, and differ most at grazing and where the colour of a facet has a kink, so they have probes of
/// their own.
/// @param without  effects that the job does without
double contribution_of_facets(const Probes& probes, const SpectralSampling& sampling, const EffectSet& without,
                              ProbeTally& tally);

/// The colour of one facet, before adaptation, by sqrt(cos(theta)). @param mechanism  without facets
XyzCurve facet_colours(const Probes& probes, Mechanism mechanism, const SpectralSampling& sampling,
                       const EffectSet& without, ProbeTally& tally);

}  // namespace nacre
