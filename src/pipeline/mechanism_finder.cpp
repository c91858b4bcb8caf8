#include "pipeline/mechanism_finder.h"

#include <memory>
#include <string>

#include "io/ceres_solver.h"
#include "io/scene/shipped_materials.h"
#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/near_materials.h"

namespace nacre {
namespace {

// Those that are known wherever there is light.
std::vector<std::shared_ptr<const IndexCurve>> materials_under(const Light& light) {
    std::vector<std::shared_ptr<const IndexCurve>> materials;
    for (const std::string& name : shipped_material_names()) {
        const auto curve = shipped_material(name);
        if (curve->first_nm <= light.settings.first_nm && curve->last_nm >= light.settings.last_nm)
            materials.push_back(curve);
    }
    return materials;
}

}  // namespace

std::vector<FoundMechanism> find_with_materials(const MechanismSearch& search, const Light& light,
                                                const std::function<void()>& after_step) {
    const LeastSquaresSolver solve = least_squares_solver();
    std::vector<FoundMechanism> found = find_mechanisms(search, light, solve, effort_for(search), after_step);
    const auto materials = materials_under(light);
    if (!materials.empty()) name_near_materials(search, light, solve, materials, found);
    return found;
}

}  // namespace nacre
