#pragma once

#include "cli/console.h"
#include "cli/pick_words.h"

namespace nacre {

/// What `nacre pick` prints for one mechanism: a scene, and in JSON what stands in its comments.
///
/// Each throws Error for what the user got wrong, and with --strict for a pick that is not met.

/// A palette of the picked colours. @param with_others  whether a film or a stack that is worth naming is looked for
void print_palette(const PickOptions& options, bool with_others, Console& console);

/// A film, stack, grating or crystal, found for picked colours or for measured spectra.
void print_found_mechanism(const PickOptions& options, Console& console);

/// The best of all mechanisms that picks can lead to, and beside it what the others make of them.
void print_best_mechanism(const PickOptions& options, Console& console);

/// The palette that comes nearest to measured spectra.
void print_measured_palette(const PickOptions& options, Console& console);

}  // namespace nacre
