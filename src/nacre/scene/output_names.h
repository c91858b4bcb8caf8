#pragma once

#include <map>
#include <string>
#include <vector>

#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

/// Names of the files that a LUT or a swatch is written to, without a folder.
std::vector<std::string> output_files(const PlannedLut& lut);
std::vector<std::string> output_files(const PlannedSwatch& swatch);
/// The same of the preview of a LUT.
std::string preview_file(const PlannedLut& lut);

/// Which file is whose, over one plan or several: no two may write the same.
class OutputNames {
public:
    /// Throws Error, naming both places, if a file of the plan is taken already. Names are compared without case: the
    /// files go to systems that do not tell Morpho.exr from morpho.exr.
    void claim(const Plan& plan);

private:
    void claim(const std::string& file, const Where& where);

    std::map<std::string, std::string> taken_;  // lower-case file name to the place that claimed it
};

}  // namespace nacre
