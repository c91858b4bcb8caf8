#include "nacre/shade/kinks.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/shade/layered_colour.h"
#include "nacre/shade/shading.h"

namespace nacre {
namespace {

// Where total reflection begins. Where the index depends on the wavelength there is an angle for each, and the sum over
// them is smooth.
std::vector<double> critical_angles_deg(const LayerSystem& system) {
    constexpr double any_nm = 550.0;
    constexpr std::size_t most_angles = 32;
    const double n0 = system.index_at(system.incident, any_nm).real();
    std::vector<double> angles_deg;
    for (std::size_t i = 0; i < system.media.size() && angles_deg.size() < most_angles; ++i) {
        if (system.media[i].share != 0.0) continue;
        const auto curve = static_cast<std::size_t>(system.media[i].curve);
        const Index& index = system.curves[curve];
        if (!index.is_constant() || index.constant.imag() != 0.0 || index.constant.real() >= n0) continue;
        angles_deg.push_back(std::asin(index.constant.real() / n0) * 180.0 / std::numbers::pi);
    }
    return angles_deg;
}

}  // namespace

std::vector<double> kinks_deg(const Mechanism& mechanism) {
    return shading_of(mechanism).kinks_deg(mechanism);
}

std::vector<double> layered_kinks_deg(const Mechanism& mechanism) {
    return critical_angles_deg(even_system(mechanism));
}

}  // namespace nacre
