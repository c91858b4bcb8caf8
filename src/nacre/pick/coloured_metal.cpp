#include "nacre/pick/coloured_metal.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "nacre/base/spectrum.h"
#include "nacre/optics/base.h"
#include "nacre/pick/smooth_rgb.h"

namespace nacre {
namespace {

// Sigmoids of pure colours round to 1 in double; what this takes away is less than the colour's own error.
constexpr double most_reflectance = 1.0 - 1e-10;

// A LUT over F0 needs it for every row. In one step it takes a quarter of the time, and rarely ends elsewhere.
Base smooth_reflectance(const std::array<double, 3>& rgb) {
    constexpr double close = 1e-9;  // in CIEDE2000: a hundred times what rounding leaves, XYZ within about 1e-11
    const Upsampled found = upsampled(rgb, 1);
    return found.ciede2000 <= close ? found.base : upsampled(rgb).base;
}

}  // namespace

std::shared_ptr<const IndexCurve> coloured_metal(const MetalColour& colour) {
    const Base f0 = smooth_reflectance(colour.f0);
    std::optional<Base> edge_tint;
    if (colour.edge_tint) edge_tint = smooth_reflectance(*colour.edge_tint);
    const WavelengthGrid grid;
    SampledCurve n, k;
    for (int node = 0; node < grid.count; ++node) {
        const double nm = grid.wavelength_nm(node);
        const double reflectance = std::min(diffuse_reflectance(f0, nm), most_reflectance);
        const RefractiveIndex index =
            edge_tint ? metal_index(reflectance, diffuse_reflectance(*edge_tint, nm)) : metal_index(reflectance);
        n.wavelength_nm.push_back(nm);
        n.value.push_back(index.real());
        k.value.push_back(index.imag());
    }
    k.wavelength_nm = n.wavelength_nm;
    IndexCurve curve;
    curve.name = "f0";
    curve.first_nm = grid.first_nm;
    curve.last_nm = grid.last_nm;
    if (edge_tint) curve.n = std::move(n);
    curve.k = std::move(k);
    curve.metal = colour;
    return std::make_shared<const IndexCurve>(std::move(curve));
}

MetalColour with_f0(const MetalColour& colour, double level) {
    MetalColour metal = colour;
    const double largest = *std::max_element(colour.f0.begin(), colour.f0.end());
    for (double& component : metal.f0) component = largest > 0.0 ? level * (component / largest) : level;
    return metal;
}

}  // namespace nacre
