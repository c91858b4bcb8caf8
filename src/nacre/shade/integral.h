#pragma once

#include <array>

#include "nacre/base/words.h"

namespace nacre {

/// How a band of reflectance becomes XYZ: in closed form, or by running moments, which err by CIEDE2000 0.001 or less
/// but for rare flanks (see lobe_to_xyz_fast()).
enum class Integral { exact, fast };

inline constexpr std::array integral_words{
    Word<Integral>{"exact", Integral::exact, "in closed form, to rounding"},
    Word<Integral>{"fast", Integral::fast, "by running moments, within CIEDE2000 0.003"},
};

}  // namespace nacre
