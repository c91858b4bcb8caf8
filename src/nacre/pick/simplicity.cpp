#include "nacre/pick/simplicity.h"

#include "nacre/optics/layered.h"

namespace nacre {
namespace {

// A layer more is as much as so many nanometres.
constexpr double nm_per_layer = 100.0;

double thickness_nm(const std::vector<Layer>& layers) {
    double sum = 0.0;
    for (const Layer& layer : layers) {
        const double one = layer.repeat > 0
                               ? layer.repeat * thickness_nm(layer.layers)
                               : 0.5 * (layer.thickness_nm + layer.last_thickness_nm.value_or(layer.thickness_nm));
        sum += one;
    }
    return sum;
}

}  // namespace

double complexity_of(const Mechanism& mechanism) {
    struct Visitor {
        double operator()(const Palette&) const { return 0.0; }
        double operator()(const Film& film) const { return nm_per_layer + film.thickness_nm; }
        double operator()(const Stack& stack) const {
            return nm_per_layer * expanded_layers(stack.layers) + thickness_nm(stack.layers);
        }
        double operator()(const Grating& grating) const {
            return grating.grooves * grating.period_nm + grating.depth_nm;
        }
        double operator()(const Crystal& crystal) const { return crystal.planes * plane_spacing_nm(crystal); }
        double operator()(const Scatter&) const { return 0.0; }
        double operator()(const MeasuredSpectra&) const { return 0.0; }
    };
    return std::visit(Visitor{}, static_cast<const MechanismModel&>(mechanism));
}

}  // namespace nacre
