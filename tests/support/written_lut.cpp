#include "support/written_lut.h"

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace nacre::test {

std::optional<WrittenLut> read_written_lut(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input || input->spec().nchannels != 3) return std::nullopt;
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 3);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data())) return std::nullopt;
    WrittenLut lut;
    lut.pixels = {spec.width, spec.height, {}};
    for (std::size_t i = 0; i < values.size(); i += 3)
        lut.pixels.rgb.push_back({values[i], values[i + 1], values[i + 2]});
    if (spec.format != OIIO::TypeDesc::HALF) lut.format = reference::StoredAs::single_float;
    const std::string reached(spec.get_string_attribute("nacre:accuracyReached"));
    if (!reached.empty()) lut.reached = std::strtod(reached.c_str(), nullptr);
    return lut;
}

std::string reason_of_refusal(const std::string& messages, const std::string& name) {
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        const auto place = line.find(" " + name + ": max_de00 = ");
        const auto best = line.find(" cannot be reached; the best is ");
        if (place == std::string::npos || best == std::string::npos) continue;
        for (const char* format : {" half: ", " float: "}) {
            const auto reason = line.find(format, best);
            if (reason != std::string::npos) return line.substr(reason + std::string(format).size());
        }
    }
    return "";
}

}  // namespace nacre::test
