#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <memory>
#include <vector>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/lut/sampler.h"

/// What benchmarks of LUTs share.
namespace nacre::bench {

inline constexpr int texels = 256;
using Colours = std::vector<Xyz>;

inline std::shared_ptr<const Light> d65() {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    return std::make_shared<const Light>(make_light(settings));
}

/// With what is needed for CIEDE2000 0.001; 0.1 for a mean of uneven layers.
inline Job decided(const Mechanism& mechanism) {
    Job job;
    job.material = {"bench", mechanism, {}};
    job.light = d65();
    job.x = default_axis(quantity_of(mechanism));
    job.width = texels;
    job.sampling = choose_sampling(job, {}).sampling;
    return job;
}

inline Geometry geometry_of_texel(const Job& job, int i) {
    return geometry_at(job, coordinate_of_texel(i, texels), 0.0);
}

/// Of this processor: a shared machine's wall clock counts its other tenants too.
inline double seconds_of(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

inline Colours colours_of(const Image<Xyz>& image) {
    Colours colours;
    for (int i = 0; i < image.width(); ++i) colours.push_back(image.at(i, 0));
    return colours;
}

/// CIEDE2000, at the scale of the truth's brightest.
inline double largest_difference(const Colours& one, const Colours& truth) {
    double brightest = 0.0;
    for (const Xyz& colour : truth) brightest = std::max(brightest, colour.y);
    double largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        largest = std::max(largest, difference_at(one[i], truth[i], display_scale(brightest)));
    return largest;
}

}  // namespace nacre::bench
