#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "nacre/base/sampled_curve.h"

namespace nacre {

/// Names of the CIE illuminants that are compiled in: D65, D50, D55, D75, A, E, FL2, FL7, FL11.
std::vector<std::string_view> illuminant_names();

/// Relative spectral power (any scale) of a CIE illuminant at its 5 nm nodes; nothing for an unknown name.
///
/// FL1 .. FL12 of 5 nm are a table of their own, not samples of the line-resolved 1 nm one.
std::optional<SampledCurve> illuminant_by_name(std::string_view name);

}  // namespace nacre
