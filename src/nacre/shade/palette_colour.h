#pragma once

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/work.h"

namespace nacre {

/// The colour of one band by the closed form, before adaptation.
Xyz lobe_to_xyz(const Light& light, const Lobe& lobe);

/// The colour of a palette's bands.
class PaletteColour {
public:
    /// @param light  has to outlive this
    PaletteColour(const Palette& palette, const Light& light) : curve_(palette), light_(&light) {}

    void reset(const Palette& palette) { curve_.reset(palette); }
    Lobe lobe_at(const Incidence& incidence) { return curve_.at(incidence); }
    /// Before adaptation. @param work  what it takes is added
    Xyz at(const Incidence& incidence, Work& work);

private:
    PaletteCurve curve_;
    const Light* light_;
};

}  // namespace nacre
