#pragma once

#include "nacre/lut/job.h"
#include "nacre/material/mechanism.h"

namespace nacre {

/// What choosing and measuring a LUT has to know of a mechanism beyond what shade/ tells of it (is_layered(),
/// samples_spectra(), is_irregular()): one row per mechanism, in mechanism_traits.cpp.
struct MechanismTraits {
    /// Whether a colour is an integral in closed form, so cheap that a search needs no limit of effort.
    bool is_closed_form = false;
    /// Whether its index changes continuously, so that it is cut into slices.
    bool has_slices = false;
    /// What one colour of Reference takes, in reflectances of a film; null: so little that it does not count.
    double (*reference_cost)(const Job& job, const Mechanism& mechanism) = nullptr;
};

MechanismTraits traits_of(const Mechanism& mechanism);

}  // namespace nacre
