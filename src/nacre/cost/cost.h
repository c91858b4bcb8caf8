#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// Ways to make a LUT that belong together: one line or group of points in a picture of cost.
enum class CostFamily {
    integral,    ///< how a spectrum becomes XYZ, everything else as exact as possible
    fixed_size,  ///< sizes that one may fix, per axis and format
    mistake,     ///< common mistakes, at 256 texels
    effect,      ///< every effect of the material switched off in turn, everything else as exact as possible
    choice,      ///< nacre's choice for a bound
};

/// One way to make the LUT of a job.
struct CostCase {
    CostFamily family = CostFamily::choice;
    std::string label;                           ///< "5 nm sum"; for a choice the bound, "0.1"
    std::string axis;                            ///< name of the x axis
    std::string format;                          ///< "half", "float", "8 bit"
    Job job;                                     ///< size and axes; where the error is looked for
    double bound = 0.0;                          ///< of a choice
    bool is_reached = true;                      ///< whether a choice keeps its bound
    double predicted = 0.0;                      ///< error that choose_lut() predicts for a choice; 0: nobody does
    std::size_t bytes = 0;                       ///< of the texels
    double sampled_for = 0.0;                    ///< bound that the job's sampling is for; its check is as fine
    bool needs_sampling = false;                 ///< whether `make` takes that sampling: nacre had to decide on it
    std::function<Image<Rgb>()> make;            ///< makes the LUT, as stored; this is what is timed
    std::function<LutPoint(LutPoint)> fetch_at;  ///< where a mistaken shader fetches; empty: at the right place
};

/// Every case for a LUT: five sums, three wavelengths, fits, and the exact integral; sizes 32 to 1024 under each angle
/// axis, in half and float; common mistakes; and nacre's own choice for bounds from 5 to 0.002 and `bound`.
///
/// `wavelengths` of the scene do not count: how spectra become XYZ is what is compared. A job over two axes keeps its
/// second one, at the height that choose_lut() gives it.
/// @param encoding  has to outlive the cases
/// @pre the encoding has a way back to XYZ
/// @param after_step  called often; what it throws ends the search
std::vector<CostCase> cost_cases(const PlannedLut& lut, const Encoding& encoding, double bound,
                                 const AfterRow& after_step = {});

/// The texels of a job, converted and rounded as the format holds them.
Image<Rgb> stored_lut(const Job& job, PixelFormat format, const Encoding& encoding);

}  // namespace nacre
