#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/readers/csv_keys.h"
#include "nacre/scene/readers/index_reader.h"
#include "nacre/scene/readers/light_reader.h"
#include "nacre/scene/readers/pick_reader.h"

namespace nacre {

/// How the core asks for a table of spectra at several angles. What comes back keeps MeasuredSpectra's promises. Throws
/// Error (with the line and column in that file) or IoError.
using SpectraReader = std::function<MeasuredSpectra(const std::string& file, const Where& where, const CsvKeys& keys)>;

/// What reading a material may need of the world around its table.
struct SceneContext {
    IndexReader index;
    CurveReader read_curve;
    SpectraReader read_spectra;
    PickReaders picks{};
    /// Looks for mechanisms that show given colours, best first; at least one.
    std::function<std::vector<FoundMechanism>(const MechanismSearch&)> find_mechanisms{};
};

}  // namespace nacre
