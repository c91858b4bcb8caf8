#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/material/effects.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// What a scene says of a LUT's accuracy. What it leaves open is decided by choose_lut(), where the colour space is
/// known.
struct AccuracyRequest {
    double max_de00 = default_max_de00;  ///< largest CIEDE2000 error of what a shader fetches
    /// Whether there is a bound at all: not so where the scene gives `size` or `wavelengths` and no bound.
    bool has_bound = true;
    /// Whether the user gave it: then a LUT that errs by more is refused. The default is a goal; who misses it is
    /// warned.
    bool is_binding = false;
    std::optional<int> width;
    std::optional<int> height;
    std::optional<PixelFormat> format;
    SamplingCounts sampling;  ///< how many points sums have; 0: to be chosen
    /// Whether effects that make no difference that counts are left out; else all are simulated but these.
    bool may_drop_effects = true;
    EffectSet without;

    static constexpr double default_max_de00 = 0.1;
};

/// A picture of the LUT beside it, NAME.preview.png: automatic is one that nobody asked for, so that it is no failure
/// if it cannot be drawn.
enum class Preview { none, automatic, asked };

/// One LUT: <name>.exr and what goes with it.
struct PlannedLut {
    std::string name;
    std::string entry;        ///< what the scene calls it: "hero" of hero_s, hero_p, hero_r and hero_t
    bool is_of_pair = false;  ///< whether it is one of the two that quantity = "both" makes
    Job job;                  ///< its size is a placeholder until choose_lut() has decided it; so is the format
    AccuracyRequest request;
    LutColour colour;
    PixelFormat format = PixelFormat::half_float;
    std::vector<LutOutput> outputs{LutOutput::exr, LutOutput::json};
    Preview preview = Preview::none;  ///< what the front end wants; a scene does not say
    std::vector<std::string> edits;  ///< what was changed in the scene before it was planned: "accuracy.max_de00 = 0.5"
    Where where;
};

/// Bounds that a user may give: below the least, single precision drowns in its own rounding.
inline constexpr Allowed allowed_max_de00{1e-5, 100.0};

/// A size that suits most materials, where none can be chosen by its error.
inline constexpr int usual_lut_width = 256;
inline constexpr int usual_lut_height = 64;

/// The longest side of a LUT over two axes, in texels: every device takes it that is made for pictures like that.
inline constexpr int largest_lut_size = 4096;

/// The longest LUT over one axis: Direct3D since its feature level 11.0 guarantees so many texels, and what Vulkan and
/// Metal run on at a desk has as many. OpenGL ES 3 and Vulkan guarantee less, 2048 and 4096.
inline constexpr int widest_lut_size = 16384;

}  // namespace nacre
