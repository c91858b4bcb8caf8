#include "nacre/lut/fetch.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace nacre {
namespace {

// The two neighbours along one axis and the second one's weight.
struct Neighbours {
    int first;
    int second;
    double weight;
};

Neighbours neighbours_of(double coordinate, int size) {
    assert(coordinate >= 0.0 && coordinate <= 1.0);
    const double position = coordinate * (size - 1);
    const int first = std::min(static_cast<int>(position), std::max(size - 2, 0));
    return {first, std::min(first + 1, size - 1), position - first};
}

Rgb mix(const Rgb& a, const Rgb& b, double t) {
    return {std::lerp(a.r, b.r, t), std::lerp(a.g, b.g, t), std::lerp(a.b, b.b, t)};
}

}  // namespace

Rgb fetch(const Image<Rgb>& lut, LutPoint point) {
    const Neighbours x = neighbours_of(point.x, lut.width());
    const Neighbours y = neighbours_of(point.y, lut.height());
    const Rgb upper = mix(lut.at(x.first, y.first), lut.at(x.second, y.first), x.weight);
    if (y.first == y.second || y.weight == 0.0) return upper;
    return mix(upper, mix(lut.at(x.first, y.second), lut.at(x.second, y.second), x.weight), y.weight);
}

}  // namespace nacre
