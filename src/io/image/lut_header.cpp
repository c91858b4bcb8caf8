// The parts of lut_file.h that need no OpenImageIO: the page has them too.
#include <Imath/half.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "io/image/lut_file.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"

namespace nacre {

std::string LutHeader::value(const std::string& name) const {
    const auto found =
        std::find_if(nacre.begin(), nacre.end(), [&](const auto& attribute) { return attribute.first == name; });
    return found == nacre.end() ? std::string() : found->second;
}

double stored_value(double value, PixelFormat format) {
    const auto single = static_cast<float>(value);
    return format == PixelFormat::half_float ? static_cast<double>(static_cast<float>(Imath::half(single)))
                                             : static_cast<double>(single);
}

void check_storable(const Image<Rgb>& image, PixelFormat format) {
    const double largest = format == PixelFormat::half_float ? static_cast<double>(HALF_MAX)
                                                             : static_cast<double>(std::numeric_limits<float>::max());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (const double value : {image.at(x, y).r, image.at(x, y).g, image.at(x, y).b}) {
                if (std::abs(value) <= largest) continue;
                throw Error("texel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " + number_text(value) +
                            "; " + (format == PixelFormat::half_float ? "half" : "float") + " holds up to " +
                            number_text(largest));
            }
        }
    }
}

}  // namespace nacre
