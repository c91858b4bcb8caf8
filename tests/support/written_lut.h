#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "reference/lut.h"

namespace nacre::test {

/// A LUT as the program wrote it, read by OpenImageIO alone.
struct WrittenLut {
    reference::Pixels pixels;
    reference::StoredAs format = reference::StoredAs::half_float;
    double reached = -1.0;  ///< nacre:accuracyReached of its header; negative: it has none

    const char* format_name() const { return format == reference::StoredAs::half_float ? "half" : "float"; }
};

/// Nothing if there is no such file, or if it has other than three channels.
std::optional<WrittenLut> read_written_lut(const std::filesystem::path& path);

/// Why a LUT is not as accurate as was asked, from what the program wrote to standard error; nothing if it does not say
/// so of a LUT of this name.
std::string reason_of_refusal(const std::string& messages, const std::string& name);

}  // namespace nacre::test
