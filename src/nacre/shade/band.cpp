#include "nacre/shade/band.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nacre/shade/layered_colour.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

constexpr double farthest_peak = 0.15;
constexpr double scan_from = 0.6;
constexpr double scan_to = 1.6;
constexpr int steps_per_wavelength = 256;
constexpr double accuracy_nm = 0.005;

struct Samples {
    std::vector<double> nm;
    std::vector<double> reflectance;
};

Samples sample(const Mechanism& mechanism, const Incidence& incidence, double from_nm, double to_nm, int steps) {
    Samples samples;
    for (int i = 0; i <= steps; ++i)
        samples.nm.push_back(std::lerp(from_nm, to_nm, static_cast<double>(i) / static_cast<double>(steps)));
    const std::vector<Response> responses =
        samples_spectra(mechanism) ? LayeredSpectra(mechanism, samples.nm, band_thickness_samples).at(incidence)
                                   : responses_at(mechanism, incidence, samples.nm);
    for (const Response& response : responses) samples.reflectance.push_back(response.reflectance());
    return samples;
}

// The highest of the samples in [first, last]; none if it is the first or the last of them.
std::optional<std::size_t> highest_inside(const Samples& samples, double first_nm, double last_nm) {
    const auto index_of = [&](double nm) { return std::lower_bound(samples.nm.begin(), samples.nm.end(), nm); };
    const auto first = samples.reflectance.begin() + (index_of(first_nm) - samples.nm.begin());
    const auto last = samples.reflectance.begin() + (index_of(last_nm) - samples.nm.begin());
    const auto highest = std::max_element(first, last);
    if (highest == first || highest + 1 >= last) return std::nullopt;
    return static_cast<std::size_t>(highest - samples.reflectance.begin());
}

// Where the samples fall to a level, going from `peak` by `step` (1 or -1).
std::optional<double> crossing_nm(const Samples& samples, std::size_t peak, std::ptrdiff_t step, double level) {
    const std::vector<double>& r = samples.reflectance;
    const auto end = step < 0 ? std::ptrdiff_t{-1} : static_cast<std::ptrdiff_t>(r.size());
    for (auto i = static_cast<std::ptrdiff_t>(peak); i + step != end; i += step) {
        const auto here = static_cast<std::size_t>(i);
        const auto next = static_cast<std::size_t>(i + step);
        if (r[next] > level) continue;
        return std::lerp(samples.nm[here], samples.nm[next], (r[here] - level) / (r[here] - r[next]));
    }
    return std::nullopt;
}

}  // namespace

std::optional<Band> find_band(const Mechanism& mechanism, const Incidence& incidence, double expected_nm) {
    constexpr int scan_steps = static_cast<int>((scan_to - scan_from) * steps_per_wavelength);
    const Samples scan = sample(mechanism, incidence, scan_from * expected_nm, scan_to * expected_nm, scan_steps);
    const auto found = highest_inside(scan, (1.0 - farthest_peak) * expected_nm, (1.0 + farthest_peak) * expected_nm);
    if (!found) return std::nullopt;
    Band band{scan.nm[*found], scan.reflectance[*found], 0.0};
    for (double step_nm = scan.nm[1] - scan.nm[0]; step_nm > accuracy_nm;) {
        constexpr int finer = 16;
        const Samples near = sample(mechanism, incidence, band.peak_nm - step_nm, band.peak_nm + step_nm, finer);
        const auto highest = std::max_element(near.reflectance.begin(), near.reflectance.end());
        band.height = *highest;
        band.peak_nm = near.nm[static_cast<std::size_t>(highest - near.reflectance.begin())];
        step_nm *= 2.0 / finer;
    }
    const double half = 0.5 * band.height;
    const auto left_nm = crossing_nm(scan, *found, -1, half);
    const auto right_nm = crossing_nm(scan, *found, 1, half);
    if (!left_nm || !right_nm) return std::nullopt;
    band.half_height_width_nm = *right_nm - *left_nm;
    return band;
}

}  // namespace nacre
