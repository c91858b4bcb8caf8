#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

/// XXH3, 64 bits: detects accidental differences, not hostile ones.
std::uint64_t hash_of(std::string_view bytes);

/// XXH3, 128 bits, as 32 hexadecimal digits (canonical byte order): names a content.
std::string hash_text(std::string_view bytes);

}  // namespace nacre
