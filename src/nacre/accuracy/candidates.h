#pragma once

#include <cstdint>
#include <vector>

#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// A size and format that a LUT might have.
struct Candidate {
    int width;
    int height;
    PixelFormat format;

    std::int64_t texels() const { return std::int64_t{width} * height; }
    std::int64_t bytes() const { return texels() * (format == PixelFormat::half_float ? 6 : 12); }
};

/// Whatever a request leaves open, by bytes; of equals the one in half first.
///
/// Sides are powers of two up to largest_lut_size, over one axis up to widest_lut_size; what the request gives is taken
/// as it is, and if that is every side, at any number of texels.
/// @param narrowest,lowest  least width and height
/// @param fewest,most       texels in all
std::vector<Candidate> candidates_from(const AccuracyRequest& request, bool is_2d, int narrowest, int lowest,
                                       std::int64_t fewest, std::int64_t most);

}  // namespace nacre
