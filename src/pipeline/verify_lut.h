#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/image/lut_file.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/colour_space.h"

namespace nacre {

/// What verifying a file found.
struct Verification {
    std::vector<std::string> missing;  ///< header attributes that are not there
    std::vector<std::string> wrong;    ///< attributes that contradict the scene in the header
    std::string problem;               ///< why the LUT cannot be derived again; empty if it can
    std::size_t differing = 0;         ///< components that are not the re-bake's
    double largest_difference = 0.0;   ///< of linear RGB
    /// CIEDE2000 error of what a shader fetches from the file, measured anew; nothing if it cannot be known.
    std::optional<double> error;

    bool passed() const { return missing.empty() && wrong.empty() && problem.empty() && differing == 0; }
};

/// The colour space whose ColourSpace::transform_text() is `text`.
/// @param where       for messages
/// @param interop_id  which of the ids that the numbers allow is meant
/// @throws Error for text that is no such transform
using ReadColourSpace = std::function<std::shared_ptr<const ColourSpace>(
    const std::string& text, const std::string& name, const std::string& where, const std::string& interop_id)>;

/// Derives a LUT again from nothing but its header, and compares every component and every attribute.
///
/// Taken on trust is what a header alone cannot prove: that its colour transform is that of the config it names. The
/// transform's own interop id and chromaticities are compared. Reads no file but a temporary one of its own; hostile
/// headers are refused before anything large is computed.
/// @throws IoError if the system refuses that file
/// @param after_row  called during the re-bake; what it throws ends it
Verification verify_lut(const StoredLut& stored, const ReadColourSpace& read_space, const AfterRow& after_row = {});

}  // namespace nacre
