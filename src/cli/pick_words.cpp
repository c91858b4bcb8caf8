#include "cli/pick_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <system_error>
#include <utility>

#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/hex_colour.h"

namespace nacre {
namespace {

double number_in(const std::string& text, const std::string& argument, const char* what) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, value);
    if (!text.empty() && failure == std::errc() && rest == end) return value;
    throw Error(argument + ": " + in_quotes(text) + " is not " + what + "; give COLOUR@ANGLE, as in \"#22cc66@0\"");
}

// "#rrggbb", "#rgb" or three numbers with commas between.
std::string colour_in(const std::string& text, const std::string& argument) {
    if (parse_hex_colour(text)) return toml_string(text);
    if (const std::string opaque = without_alpha(text); !opaque.empty()) {
        throw Error(argument + ": " + in_quotes(text) + " has an alpha component, and a reflectance has none; give " +
                    in_quotes(opaque));
    }
    if (std::count(text.begin(), text.end(), ',') != 2)
        throw Error(argument + ": " + in_quotes(text) + " is not a colour; give \"#rrggbb\", \"#rgb\" or r,g,b");
    std::string list = "[";
    std::size_t begin = 0;
    for (int component = 0; component < 3; ++component) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        list +=
            (component > 0 ? ", " : "") + number_text(number_in(text.substr(begin, end - begin), argument, "a number"));
        begin = end + 1;
    }
    return list + "]";
}

}  // namespace

std::vector<PickLine> pick_lines(const PickOptions& options) {
    std::vector<PickLine> lines;
    for (const std::string& text : options.picks) {
        const std::size_t at = text.rfind('@');
        if (at == std::string::npos) throw Error(text + ": has no angle; give COLOUR@ANGLE, as in \"#22cc66@0\"");
        const double angle_deg = number_in(text.substr(at + 1), text, "an angle");
        if (!(angle_deg >= 0.0 && angle_deg <= 90.0))
            throw Error(text + ": the angle is out of range; allowed [0, 90] degrees");
        std::string toml =
            "{ angle_deg = " + number_text(angle_deg) + ", colour = " + colour_in(text.substr(0, at), text);
        if (!options.space.empty()) toml += ", space = " + toml_string(options.space);
        lines.push_back({toml + " }", {}});
    }
    return lines;
}

void check_with(const std::vector<std::string>& with) {
    std::vector<std::string> keys;
    for (const std::string& line : with) {
        const std::string wanted =
            "; give KEY=VALUE as in a scene: index = 1.33, index = \"water\", index = { from = 1.3, to = 1.5 }";
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos || line.find('\n') != std::string::npos)
            throw Error("--with " + in_quotes(line) + " is not a key and a value" + wanted);
        std::string key = line.substr(0, equals);
        std::erase_if(key, [](unsigned char character) { return std::isspace(character) != 0; });
        try {
            parse_scene(line, "--with");
        } catch (const Error&) {
            throw Error("--with " + in_quotes(line) + " is not TOML; put text in quotes" + wanted);
        }
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            throw Error("--with " + key + " is given twice; give it once");
        keys.push_back(std::move(key));
    }
}

}  // namespace nacre
