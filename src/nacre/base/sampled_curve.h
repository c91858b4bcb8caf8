#pragma once

#include <vector>

namespace nacre {

/// A function of wavelength given at nodes, linear between them and 0 outside (the CIE's rule for illuminants).
struct SampledCurve {
    std::vector<double> wavelength_nm;  ///< strictly ascending
    std::vector<double> value;          ///< as many as there are wavelengths

    /// @pre at least one node
    double at(double nm) const;
    friend bool operator==(const SampledCurve&, const SampledCurve&) = default;
};

}  // namespace nacre
