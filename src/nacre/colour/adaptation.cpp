#include "nacre/colour/adaptation.h"

#include <glm/glm.hpp>

namespace nacre {
namespace {

// GLM stores columns: the transpose lets the rows be read as they are printed.
const glm::dmat3 bradford_cones = glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614,  //
                                                            -0.7502, 1.7135, 0.0367,  //
                                                            0.0389, -0.0685, 1.0296));
const glm::dmat3 cat16_cones = glm::transpose(glm::dmat3(0.401288, 0.650173, -0.051461,  //
                                                         -0.250268, 1.204414, 0.045854,  //
                                                         -0.002079, 0.048952, 0.953127));

const glm::dmat3& cones_of(Adaptation method) {
    return method == Adaptation::bradford ? bradford_cones : cat16_cones;
}

}  // namespace

bool can_adapt_from(Adaptation method, Xyz white) {
    if (method == Adaptation::none) return true;
    const glm::dvec3 response = cones_of(method) * glm::dvec3(white.x, white.y, white.z);
    return response.x > 0.0 && response.y > 0.0 && response.z > 0.0;
}

glm::dmat3 adaptation_matrix(Adaptation method, Xyz from_white, Xyz to_white) {
    if (method == Adaptation::none) return glm::dmat3(1.0);
    const glm::dmat3& cones = cones_of(method);
    const glm::dvec3 from = cones * glm::dvec3(from_white.x, from_white.y, from_white.z);
    const glm::dvec3 to = cones * glm::dvec3(to_white.x, to_white.y, to_white.z);
    glm::dmat3 scale(0.0);
    for (int i = 0; i < 3; ++i) scale[i][i] = to[i] / from[i];
    return glm::inverse(cones) * scale * cones;
}

Xyz adapt(const glm::dmat3& matrix, Xyz colour) {
    const glm::dvec3 result = matrix * glm::dvec3(colour.x, colour.y, colour.z);
    return {result.x, result.y, result.z};
}

}  // namespace nacre
