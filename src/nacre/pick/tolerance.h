#pragma once

#include <cstddef>
#include <vector>

namespace nacre {

/// How far a colour moves, in CIEDE2000, over everything that it may become.
struct ColourShift {
    double mean = 0.0;
    double percentile_95 = 0.0;  ///< 95 % of all stay below
    friend bool operator==(const ColourShift&, const ColourShift&) = default;
};

/// @param de00  of every sample, at least one
ColourShift shift_of(std::vector<double> de00);

/// How far colours move where a structure is made inexactly: every free thickness is off by a normal error of its own.
struct Tolerance {
    double thickness_nm = 0.0;            ///< standard deviation of the error
    ColourShift shift;                    ///< over all wanted colours
    std::vector<ColourShift> per_colour;  ///< per wanted colour
    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

/// Independent normal variables of mean 0 and variance 1, always the same: EvenPoints through the inverse of their
/// distribution, made uncorrelated.
/// Accuracy: of 2048 points in up to 6 dimensions, the mean size of any sum of them is within 2 %, and its 95th
/// percentile within 4 %; in 2 dimensions, 0.2 % and 1 %.
/// @param count  > dimensions @param dimensions  >= 1
std::vector<std::vector<double>> even_normal_points(int count, std::size_t dimensions);

}  // namespace nacre
