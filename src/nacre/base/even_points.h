#pragma once

#include <cstddef>
#include <vector>

namespace nacre {

/// Points that fill a cube evenly, however many of them are taken: along every edge a different step, a power of the
/// generalised golden ratio, wrapped around.
///
/// Source: M. Roberts 2018, "The unreasonable effectiveness of quasirandom sequences".
class EvenPoints {
public:
    /// @param dimensions  >= 1
    explicit EvenPoints(std::size_t dimensions);

    /// The point of a number >= 0, each coordinate in [0, 1).
    std::vector<double> at(int index) const;

private:
    std::vector<double> steps_;
};

}  // namespace nacre
