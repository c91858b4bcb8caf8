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
        const auto place = line.find(" " + name + ": ");
        if (place == std::string::npos || line.find("max_de00 = ", place) == std::string::npos) continue;
        // What is the matter, a colon, and why.
        const auto reason = line.find(": ", place + name.size() + 3);
        if (reason != std::string::npos) return line.substr(reason + 2);
    }
    return "";
}

}  // namespace nacre::test
