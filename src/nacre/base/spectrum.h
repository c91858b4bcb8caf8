#pragma once

#include <cassert>
#include <vector>

namespace nacre {

/// Evenly spaced wavelengths, both ends included.
struct WavelengthGrid {
    double first_nm = 360.0;
    double last_nm = 830.0;
    int count = 471;  ///< >= 2

    double step_nm() const { return (last_nm - first_nm) / (count - 1); }
    /// @param node  0 .. count - 1
    double wavelength_nm(int node) const {
        assert(node >= 0 && node < count);
        // In this order of operations whole nanometres are exact.
        return first_nm + (last_nm - first_nm) * node / (count - 1);
    }
    friend bool operator==(const WavelengthGrid&, const WavelengthGrid&) = default;
};

/// A reflectance in [0, 1] per node of a grid.
struct Spectrum {
    WavelengthGrid grid;
    std::vector<double> value;  ///< grid.count numbers
};

}  // namespace nacre
