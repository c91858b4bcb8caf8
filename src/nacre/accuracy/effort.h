#pragma once

#include <cstdint>

#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// What one colour of a job takes on average over its axes, in reflectances of a film; 1 for a palette.
/// @param job  its sampling is decided
double effort_per_colour(const Job& job);

/// What the mean over facets takes beside it; 0 without facets.
double effort_per_mean(const Job& job);

/// What a search among LUTs may take: some ten seconds, counted in reflectances of a film, so that
/// the answer is the same on every machine. Plain palettes are cheap enough to have no limit.
class Effort {
public:
    Effort() = default;
    /// @param job  its sampling is decided
    explicit Effort(const Job& job);

    /// Whether so much work is all that is worth it.
    bool is_spent(const Work& work) const;
    /// Whether it is so far beyond that the best so far has to do.
    bool is_far_beyond(const Work& work) const;
    /// Colours that a curve of them may take before it is no help: a part of that.
    double most_curve_colours() const { return most_curve_colours_; }
    /// Texels of the largest LUT that is worth trying: in 2D none may take a quarter of all that.
    std::int64_t most_texels() const { return most_texels_; }

private:
    double spent(const Work& work) const;

    double per_sample_ = 0.0;  // what a reflectance takes, in those of a film; 0: nothing that counts
    double most_curve_colours_ = 1e9;
    std::int64_t most_texels_ = std::int64_t{1} << 22;
};

}  // namespace nacre
