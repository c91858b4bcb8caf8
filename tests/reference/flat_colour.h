#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "nacre/material/mechanism.h"
#include "reference/light.h"
#include "reference/scene.h"

namespace nacre::reference {

/// The colour of a mechanism without facets, before adaptation, with wavelengths at even steps.
class FlatColour {
public:
    virtual ~FlatColour() = default;

    /// @param x  on the mechanism's own axis: sqrt(cos(theta)), u / 2, (1 + cos_scatter) / 2
    /// @param y  coordinate of the second axis
    virtual Triple at(double x, double y, double step_nm) const = 0;
    /// The same of layers with wavelengths as close as their resonances need: nanometres are halved until what a
    /// parabola misses in a part, times its width, is at most `tolerance`, a reflectance times nanometres.
    virtual Triple resolved(double /*x*/, double /*y*/, double /*tolerance*/) const {
        throw std::runtime_error("only layers have resonances");
    }
    /// Nanometres per wavelength that it takes at least to see all there is.
    virtual double longest_step_nm(double /*x*/, double /*y*/) const { return 2.0; }
    /// Of layers: faces times wavelengths that a colour takes at least.
    virtual double cost() const { return 1.0; }
};

std::unique_ptr<FlatColour> layers_colour(const ModelScene& scene, const ModelLight& light);
std::unique_ptr<FlatColour> grating_colour(const Grating& grating, const ModelLight& light);
std::unique_ptr<FlatColour> scatter_colour(const Mechanism& mechanism, const ModelLight& light);
std::unique_ptr<FlatColour> measured_colour(const MeasuredSpectra& spectra, const ModelLight& light);

inline double plus(double sum, double share, double value) {
    return sum + share * value;
}

/// A table at even steps in [0, 1], cubics through four neighbours.
template <class Value>
Value cubic_at(const std::vector<Value>& table, double x) {
    const auto count = static_cast<int>(table.size());
    const double place = x * (count - 1);
    const int cell = std::clamp(static_cast<int>(place) - 1, 0, count - 4);
    Value sum{};
    for (int j = 0; j < 4; ++j) {
        double share = 1.0;
        for (int k = 0; k < 4; ++k)
            if (k != j) share *= (place - cell - k) / (j - k);
        sum = plus(sum, share, table[static_cast<std::size_t>(cell + j)]);
    }
    return sum;
}

}  // namespace nacre::reference
