#pragma once

#include <string>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/colour_space.h"
#include "nacre/shade/work.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// Two significant digits, no exponent where it can be helped: "0.021", "1.4", "130".
std::string short_number(double value);

/// "0.083 ms", "1.2 s".
std::string duration_text(double seconds);

/// "lin_rec709 (config nacre)": the space of a LUT, and the config that it is from.
std::string space_text(const ColourSpace& space, const LoadedScene& scene);

/// "wider than 4096, which is more than some phones and browsers take", of such a LUT.
std::string width_text(const Job& job);

/// How many of each kind of step a computation took.
Json work_json(const Work& work);

}  // namespace nacre
