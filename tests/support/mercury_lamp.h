#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "nacre/base/sampled_curve.h"

namespace nacre::test {

/// Mercury's visible lines and a red one on a weak continuum, every 0.4 nm: made for these tests.
inline SampledCurve mercury_lamp() {
    struct Line {
        double nm, power, width_nm;  // full width at half maximum
    };
    constexpr std::array<Line, 6> lines{{{404.66, 1.0, 0.6},
                                         {435.83, 3.0, 0.6},
                                         {546.07, 4.0, 0.6},
                                         {576.96, 1.0, 0.6},
                                         {579.07, 1.0, 0.6},
                                         {611.4, 3.0, 0.8}}};
    SampledCurve lamp;
    for (int i = 0; i <= 1175; ++i) {
        const double nm = 360.0 + 0.4 * i;
        double power = 0.05;
        for (const Line& line : lines) {
            const double t = (nm - line.nm) / line.width_nm;
            power += line.power * std::exp(-4.0 * std::numbers::ln2 * t * t);
        }
        lamp.wavelength_nm.push_back(nm);
        lamp.value.push_back(power);
    }
    return lamp;
}

}  // namespace nacre::test
