#pragma once

#include <span>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/layer_system.h"
#include "nacre/optics/response.h"
#include "nacre/shade/prepared_colour.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// How a mechanism is shaded: one row each, in MechanismModel's order. All but tilt, which is the same for all.
struct ShadingRow {
    /// Whether its colour is a sum over sampled wavelengths: else it has a closed form.
    bool samples_spectra;
    /// See prepare_colour().
    PreparedColour (*prepare)(const Mechanism&, const SpectralSampling&, const Light&);
    /// See responses_at().
    std::vector<Response> (*responses)(const Mechanism&, const Geometry&, std::span<const double> wavelengths_nm);
    /// See kinks_deg().
    std::vector<double> (*kinks_deg)(const Mechanism&);
    /// Its layers, without spread and base; null: it is not made of layers.
    /// @param slices  per plane of a crystal
    LayerSystem (*layers)(const Mechanism&, int slices);
};

const ShadingRow& shading_of(const Mechanism& mechanism);

}  // namespace nacre
