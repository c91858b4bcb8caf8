#include "nacre/accuracy/candidates.h"

#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"

#include <algorithm>
#include <optional>

namespace nacre {
namespace {

std::vector<int> sizes_from(const std::optional<int>& request, int smallest, int largest) {
    if (request) return {*request};
    std::vector<int> sizes;
    for (int size = 2; size <= largest; size *= 2) {
        if (size >= smallest) sizes.push_back(size);
    }
    return sizes;
}

std::vector<PixelFormat> formats_of(const std::optional<PixelFormat>& request) {
    if (request) return {*request};
    return {PixelFormat::half_float, PixelFormat::single_float};
}

}  // namespace

std::vector<Candidate> candidates_from(const AccuracyRequest& request, bool is_2d, int narrowest, int lowest,
                                       std::int64_t fewest, std::int64_t most) {
    const std::vector<int> heights = is_2d ? sizes_from(request.height, lowest, largest_lut_size) : std::vector<int>{1};
    const std::vector<int> widths = sizes_from(request.width, narrowest, is_2d ? largest_lut_size : widest_lut_size);
    const bool is_given = request.width && (request.height || !is_2d);
    std::vector<Candidate> all;
    for (const int height : heights) {
        for (const int width : widths) {
            for (const PixelFormat format : formats_of(request.format)) {
                const Candidate candidate{width, height, format};
                const bool is_allowed = candidate.texels() >= fewest && candidate.texels() <= most;
                if (is_given || is_allowed) all.push_back(candidate);
            }
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.bytes() < b.bytes(); });
    return all;
}

}  // namespace nacre
