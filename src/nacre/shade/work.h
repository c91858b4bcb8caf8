#pragma once

#include <cstddef>
#include <cstdint>

#include "nacre/material/effects.h"

namespace nacre {

/// The work of a computation. It is counted and not timed, so that the same job has the same numbers on every machine.
struct Work {
    std::uint64_t exact_integrals = 0;  ///< lobes integrated in closed form
    std::uint64_t spectra = 0;          ///< spectra sampled at nodes
    std::uint64_t samples = 0;          ///< reflectances of these: their nodes, of all samples
    std::uint64_t texels = 0;           ///< of all LUTs that were computed, trials too
    std::uint64_t probes = 0;           ///< points at which a LUT's colour was compared with the model's
    std::uint64_t references = 0;       ///< points at which it was compared with the independent reference
    EffectWorks effects{};              ///< the work of each effect

    friend bool operator==(const Work&, const Work&) = default;
};

inline Work& operator+=(Work& sum, const Work& more) {
    sum.exact_integrals += more.exact_integrals;
    sum.spectra += more.spectra;
    sum.samples += more.samples;
    sum.texels += more.texels;
    sum.probes += more.probes;
    sum.references += more.references;
    for (std::size_t i = 0; i < effect_count; ++i) {
        sum.effects[i].spectra += more.effects[i].spectra;
        sum.effects[i].layers += more.effects[i].layers;
        sum.effects[i].points += more.effects[i].points;
        sum.effects[i].polarisations += more.effects[i].polarisations;
    }
    return sum;
}

}  // namespace nacre
