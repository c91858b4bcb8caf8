#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/optics/refractive_index.h"
#include "nacre/pick/find_mechanism.h"
#include "nacre/pick/mechanism_search.h"

namespace nacre {

/// The material whose index is nearest to a number over the visible range: root of the mean of |n + ik - number|^2 from
/// 400 to 700 nm.
/// @param materials  at least one, each known from 400 to 700 nm
NearMaterial near_material(const std::string& key, double n,
                           std::span<const std::shared_ptr<const IndexCurve>> materials);

/// Adds to every answer the materials that are nearest to its free indices, and its error when built from them, after
/// all other free numbers were found again from their values.
void name_near_materials(const MechanismSearch& search, const Light& light, const LeastSquaresSolver& solve,
                         std::span<const std::shared_ptr<const IndexCurve>> materials,
                         std::vector<FoundMechanism>& found);

}  // namespace nacre
