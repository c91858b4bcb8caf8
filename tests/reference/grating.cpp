#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/complex.h"
#include "reference/flat_colour.h"
#include "reference/materials.h"

namespace nacre::reference {
namespace {

// A grating's lines are midpoints, ten and more per ripple.

// |m| in [0, largest]; J_m(z) by its integral, 1 / pi times that of cos(m t - z sin t) from 0 to pi.
double bessel(int m, double z) {
    const int count = 64 + 2 * m + static_cast<int>(4.0 * z);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double t = std::numbers::pi * (i + 0.5) / count;
        sum += std::cos(m * t - z * std::sin(t));
    }
    return sum / count;
}

class GratingColour : public FlatColour {
public:
    GratingColour(const Grating& grating, const ModelLight& light) : light_(light), grating_(grating) {
        const int largest = static_cast<int>(2.0 * grating_.period_nm / light_begins_nm);
        for (int m = 0; m <= largest; ++m) {
            const bool is_named = std::find(grating_.orders.begin(), grating_.orders.end(), m) != grating_.orders.end();
            if (grating_.orders.empty() ? m > 0 : is_named) orders_.push_back(m);
        }
    }

    Triple at(double x, double /*y*/, double step_nm) const override {
        const double azimuth = grating_.azimuth_deg * std::numbers::pi / 180.0;
        const double u = 2.0 * x * std::cos(azimuth), d = grating_.period_nm;
        const double along_nm = 2.0 * x * std::sin(azimuth) * 1000.0 * grating_.groove_length_um;
        Triple sum{};
        for (double nm = light_begins_nm; nm < light_ends_nm;) {
            const double ripples_per_nm = grating_.grooves * u * d / square(nm);
            const double length = std::min({0.5 * step_nm, 0.05 * step_nm / std::max(ripples_per_nm, 1e-12),
                                            light_ends_nm - nm, std::floor(nm) + 1.0 - nm + 1e-12});
            const double middle = nm + 0.5 * length;
            double density = 0.0;
            for (std::size_t i = 0; i < orders_.size(); ++i) {
                const int m = orders_[i];
                double line = line_at(u * d / middle - m);
                if (m > 0) line += line_at(u * d / middle + m);
                density += efficiency_at(i, middle) * line;
            }
            density *= grating_.grooves * d / middle * std::exp(-std::numbers::pi * square(along_nm / middle));
            const Triple weight = light_.weight_at(middle);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += length * density * weight[c];
            nm += length;
        }
        return sum;
    }

private:
    double line_at(double from_order) const {
        const double t = grating_.grooves * from_order;
        return std::abs(t) < 1e-8 ? 1.0 : square(std::sin(std::numbers::pi * t) / (std::numbers::pi * t));
    }
    // Of one sign; slowly varying: a table.
    double efficiency_at(std::size_t i, double nm) const {
        if (efficiency_.empty()) {
            for (const int m : orders_) {
                efficiency_.emplace_back();
                for (int at_nm = light_begins_nm; at_nm <= light_ends_nm; ++at_nm)
                    efficiency_.back().push_back(exact(m, at_nm));
            }
        }
        return cubic_at(efficiency_[i], (nm - light_begins_nm) / (light_ends_nm - light_begins_nm));
    }
    double exact(int m, double nm) const {
        double coat = 1.0;
        if (grating_.coat) {
            const Complex n = index_at(*grating_.coat, nm);
            coat = squared_magnitude((n - 1.0) / (n + 1.0));
        }
        if (grating_.profile == GratingProfile::given) {
            double others = 0.0;
            for (const double efficiency : grating_.efficiency) others += 2.0 * efficiency;
            if (m == 0) return coat * (1.0 - others);
            const auto place = static_cast<std::size_t>(m) - 1;
            return place < grating_.efficiency.size() ? coat * grating_.efficiency[place] : 0.0;
        }
        const double half_phase = 2.0 * std::numbers::pi * grating_.depth_nm / nm;
        if (grating_.profile == GratingProfile::sinusoidal) return coat * square(bessel(m, half_phase));
        // Fourier's coefficient of exp(i phase) on the land and 1 beside it.
        if (m == 0)
            return coat * squared_magnitude(grating_.land * std::polar(1.0, 2.0 * half_phase) + (1.0 - grating_.land));
        const Complex of_land = (std::polar(1.0, 2.0 * half_phase) - 1.0) *
                                std::sin(std::numbers::pi * m * grating_.land) / (std::numbers::pi * m);
        return coat * squared_magnitude(of_land);
    }

    const ModelLight& light_;
    Grating grating_;
    std::vector<int> orders_;
    mutable std::vector<std::vector<double>> efficiency_;
};

}  // namespace

std::unique_ptr<FlatColour> grating_colour(const Grating& grating, const ModelLight& light) {
    return std::make_unique<GratingColour>(grating, light);
}

}  // namespace nacre::reference
