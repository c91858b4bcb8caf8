#include "nacre/pick/near_materials.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>

#include "nacre/base/least_squares.h"
#include "nacre/colour/light.h"
#include "nacre/optics/refractive_index.h"

namespace nacre {
namespace {

double distance(const IndexCurve& curve, double n) {
    constexpr int first_nm = 400;
    constexpr int last_nm = 700;
    constexpr int step_nm = 10;
    constexpr int count = (last_nm - first_nm) / step_nm + 1;
    double sum = 0.0;
    for (int nm = first_nm; nm <= last_nm; nm += step_nm) sum += std::norm(curve.at(nm) - n);
    return std::sqrt(sum / count);
}

std::size_t nearest(double n, std::span<const std::shared_ptr<const IndexCurve>> materials) {
    std::vector<double> distances;
    for (const auto& material : materials) distances.push_back(distance(*material, n));
    return static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

}  // namespace

NearMaterial near_material(const std::string& key, double n,
                           std::span<const std::shared_ptr<const IndexCurve>> materials) {
    const auto& curve = materials[nearest(n, materials)];
    return {key, curve->name, distance(*curve, n)};
}

void name_near_materials(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
                         std::span<const std::shared_ptr<const IndexCurve>> materials,
                         std::vector<FoundMechanism>& found) {
    for (FoundMechanism& answer : found) {
        MechanismSearch rest{search.start, {}, search.wanted};
        std::vector<double> values;
        for (std::size_t i = 0; i < search.free.size(); ++i) {
            const FreeNumber& number = search.free[i];
            if (!number.set_index) {
                rest.free.push_back(number);
                values.push_back(answer.values[i]);
                continue;
            }
            answer.near.push_back(near_material(number.name, answer.values[i], materials));
            number.set_index(rest.start, Index(materials[nearest(answer.values[i], materials)]));
        }
        if (!answer.near.empty()) answer.near_error = refine_mechanism(rest, light, solve, values).error;
    }
}

}  // namespace nacre
