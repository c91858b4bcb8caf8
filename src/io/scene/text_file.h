#pragma once

#include <cstddef>
#include <string>

namespace nacre {

/// The whole of a text file. Throws IoError, with the reason, if it cannot be read, is a folder, or is larger than
/// `most_bytes`.
std::string read_text_file(const std::string& path, std::size_t most_bytes);

}  // namespace nacre
