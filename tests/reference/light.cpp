#include "reference/light.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace nacre::reference {

Weights weights_of(const std::string& illuminant, int observer_deg) {
    const char* file = observer_deg == 10 ? "cmf_cie1964_10deg_1nm.csv" : "cmf_cie1931_2deg_1nm.csv";
    return weights_from_files(file, illuminant, light_begins_nm, light_ends_nm);
}

Triple WavelengthGrid::sum(const std::vector<double>& spectrum) const {
    Triple sum{};
    for (std::size_t i = 0; i < spectrum.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += spectrum[i] * weight[i][c];
    return sum;
}

ModelLight::ModelLight(const std::string& illuminant, int observer_deg) {
    const Weights table = weights_of(illuminant, observer_deg);
    const Number whole = integral_of(table.y);
    for (std::size_t i = 0; i < table.y.size(); ++i) {
        weights_.push_back({static_cast<double>(table.x[i] / whole), static_cast<double>(table.y[i] / whole),
                            static_cast<double>(table.z[i] / whole)});
    }
    const XyzNumbers white = white_of(table);
    to_d65_ = bradford_to_d65<double>({static_cast<double>(white.x), 1.0, static_cast<double>(white.z)});
}

const ModelLight& ModelLight::of(const std::string& illuminant, int observer_deg) {
    static std::map<std::pair<std::string, int>, std::unique_ptr<const ModelLight>> known;
    auto& light = known[{illuminant, observer_deg}];
    if (!light) light = std::make_unique<const ModelLight>(illuminant, observer_deg);
    return *light;
}

Triple ModelLight::weight_at(double nm) const {
    const auto cell = std::min(static_cast<std::size_t>(nm - light_begins_nm), weights_.size() - 2);
    const double t = nm - light_begins_nm - static_cast<double>(cell);
    Triple here{};
    for (std::size_t c = 0; c < 3; ++c) here[c] = (1.0 - t) * weights_[cell][c] + t * weights_[cell + 1][c];
    return here;
}

ModelXyz ModelLight::adapted(const Triple& seen) const {
    const Triple colour = to_d65_ * seen;
    return {colour[0], colour[1], colour[2]};
}

Triple ModelLight::seen_as(const ModelXyz& adapted) const {
    return inverse(to_d65_) * Triple{adapted.x, adapted.y, adapted.z};
}

const WavelengthGrid& ModelLight::grid(double step_nm) const {
    WavelengthGrid& made = grids_[step_nm];
    if (!made.nm.empty()) return made;
    const auto count = static_cast<int>(std::lround((light_ends_nm - light_begins_nm) / step_nm)) + 1;
    for (int i = 0; i < count; ++i) made.nm.push_back(light_begins_nm + i * step_nm);
    made.weight.resize(made.nm.size());
    const int parts = std::max(4, static_cast<int>(std::lround(4.0 / step_nm)));
    for (int part = 0; part < parts * (light_ends_nm - light_begins_nm); ++part) {
        const double nm = light_begins_nm + (part + 0.5) / parts;
        const int cell = std::clamp(static_cast<int>((nm - light_begins_nm) / step_nm) - 1, 0, count - 4);
        const double t = (nm - light_begins_nm) / step_nm - cell;
        const Triple weight = weight_at(nm);
        for (int j = 0; j < 4; ++j) {
            double share = 1.0 / parts;
            for (int k = 0; k < 4; ++k)
                if (k != j) share *= (t - k) / (j - k);
            Triple& sum = made.weight[static_cast<std::size_t>(cell + j)];
            for (std::size_t c = 0; c < 3; ++c) sum[c] += share * weight[c];
        }
    }
    return made;
}

}  // namespace nacre::reference
