#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/complex.h"
#include "reference/flat_colour.h"
#include "reference/materials.h"

namespace nacre::reference {
namespace {

class MeasuredColour : public FlatColour {
public:
    MeasuredColour(const MeasuredSpectra& spectra, const ModelLight& light) : light_(light), spectra_(spectra) {}

    Triple at(double x, double /*y*/, double step_nm) const override {
        const double theta_deg = std::acos(std::min(x * x, 1.0)) * 180.0 / std::numbers::pi;
        SampledCurve spectrum{spectra_.wavelength_nm, {}};
        for (std::size_t i = 0; i < spectra_.wavelength_nm.size(); ++i)
            spectrum.value.push_back(at_angle(i, theta_deg));
        const int parts = static_cast<int>(std::lround(8.0 / step_nm));
        Triple sum{};
        for (int part = 0; part < parts * (light_ends_nm - light_begins_nm); ++part) {
            const double nm = light_begins_nm + (part + 0.5) / parts, r = linear_at(spectrum, nm, true) / parts;
            const Triple weight = light_.weight_at(nm);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += r * weight[c];
        }
        return sum;
    }

private:
    double value(std::size_t angle, std::size_t wavelength) const {
        return spectra_.reflectance[angle * spectra_.wavelength_nm.size() + wavelength];
    }
    // Fritsch and Butland's slopes in the form of Matlab's pchip; Hermite's basis.
    double at_angle(std::size_t i, double theta_deg) const {
        const std::vector<double>& at = spectra_.angle_deg;
        const std::size_t count = at.size();
        if (count == 1 || theta_deg <= at.front()) return value(0, i);
        if (theta_deg >= at.back()) return value(count - 1, i);
        const auto h = [&](std::size_t k) { return at[k + 1] - at[k]; };
        const auto secant = [&](std::size_t k) { return (value(k + 1, i) - value(k, i)) / h(k); };
        const auto end = [&](std::size_t k, std::size_t next) {
            const double d = ((2.0 * h(k) + h(next)) * secant(k) - h(k) * secant(next)) / (h(k) + h(next));
            if (d * secant(k) <= 0.0) return 0.0;
            return std::abs(d) > 3.0 * std::abs(secant(k)) ? 3.0 * secant(k) : d;
        };
        const auto slope = [&](std::size_t k) {
            if (count == 2) return secant(0);
            if (k == 0) return end(0, 1);
            if (k == count - 1) return end(count - 2, count - 3);
            if (secant(k - 1) * secant(k) <= 0.0) return 0.0;
            const double w1 = 2.0 * h(k) + h(k - 1), w2 = h(k) + 2.0 * h(k - 1);
            return (w1 + w2) / (w1 / secant(k - 1) + w2 / secant(k));
        };
        std::size_t k = 0;
        while (at[k + 1] < theta_deg) ++k;
        const double t = (theta_deg - at[k]) / h(k);
        return value(k, i) * (1.0 + 2.0 * t) * square(1.0 - t) + slope(k) * h(k) * t * square(1.0 - t) +
               value(k + 1, i) * t * t * (3.0 - 2.0 * t) + slope(k + 1) * h(k) * t * t * (t - 1.0);
    }

    const ModelLight& light_;
    MeasuredSpectra spectra_;
};

}  // namespace

std::unique_ptr<FlatColour> measured_colour(const MeasuredSpectra& spectra, const ModelLight& light) {
    return std::make_unique<MeasuredColour>(spectra, light);
}

}  // namespace nacre::reference
