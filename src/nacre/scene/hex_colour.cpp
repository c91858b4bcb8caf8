#include "nacre/scene/hex_colour.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace nacre {

std::optional<Rgb> parse_hex_colour(const std::string& text) {
    if (text.size() != 4 && text.size() != 7) return {};
    if (text.front() != '#') return {};
    std::vector<int> digits;
    for (const char character : text.substr(1)) {
        const auto byte = static_cast<unsigned char>(character);
        if (std::isxdigit(byte) == 0) return {};
        digits.push_back(std::isdigit(byte) != 0 ? character - '0' : std::tolower(byte) - 'a' + 10);
    }
    const auto component = [&](std::size_t i) {
        return digits.size() == 3 ? digits[i] / 15.0 : (16 * digits[2 * i] + digits[2 * i + 1]) / 255.0;
    };
    return Rgb{component(0), component(1), component(2)};
}

std::string without_alpha(const std::string& text) {
    const std::size_t opaque = text.size() == 5 ? 4 : text.size() == 9 ? 7 : 0;
    if (opaque == 0 || !parse_hex_colour(text.substr(0, opaque))) return "";
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(opaque), text.end(), is_digit)
               ? text.substr(0, opaque)
               : "";
}

}  // namespace nacre
