#include "web/plain_exr.h"

#include <Imath/half.h>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>

namespace nacre {
namespace {

// Little-endian, as the format has it on every machine.
template <typename Number>
void put(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i)
        bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xff);
}

void put_float(std::string& bytes, float number) {
    std::uint32_t bits = 0;  // std::bit_cast, which Emscripten 3.1.6 lacks
    static_assert(sizeof bits == sizeof number);
    std::memcpy(&bits, &number, sizeof bits);
    put(bytes, bits);
}

struct Attribute {
    std::string_view type;
    std::string value;
};

std::string channels(PixelFormat format) {
    constexpr std::uint32_t half_pixels = 1;
    constexpr std::uint32_t float_pixels = 2;
    std::string bytes;
    for (const char name : {'B', 'G', 'R'}) {  // by name, as the format demands
        bytes += name;
        bytes += '\0';
        put(bytes, format == PixelFormat::half_float ? half_pixels : float_pixels);
        put(bytes, std::uint32_t{0});  // not perceptually linear, and three reserved bytes
        put(bytes, std::uint32_t{1});  // every column
        put(bytes, std::uint32_t{1});  // every row
    }
    return bytes + '\0';
}

std::string window(int width, int height) {
    std::string bytes;
    for (const int number : {0, 0, width - 1, height - 1}) put(bytes, static_cast<std::uint32_t>(number));
    return bytes;
}

std::string floats(std::initializer_list<float> numbers) {
    std::string bytes;
    for (const float number : numbers) put_float(bytes, number);
    return bytes;
}

// In the order of their names, as OpenEXR writes them; with those that OpenImageIO adds by itself.
std::map<std::string, Attribute> attributes_of(const Image<Rgb>& image, PixelFormat format, const LutHeader& header) {
    std::map<std::string, Attribute> attributes{
        {"Software", {"string", header.software}},
        {"capDate", {"string", {}}},
        {"channels", {"chlist", channels(format)}},
        {"compression", {"compression", std::string(1, '\0')}},
        {"dataWindow", {"box2i", window(image.width(), image.height())}},
        {"displayWindow", {"box2i", window(image.width(), image.height())}},
        {"lineOrder", {"lineOrder", std::string(1, '\0')}},
        {"pixelAspectRatio", {"float", floats({1.0f})}},
        {"screenWindowCenter", {"v2f", floats({0.0f, 0.0f})}},
        {"screenWindowWidth", {"float", floats({1.0f})}},
    };
    if (!header.interop_id.empty()) attributes["colorInteropID"] = {"string", header.interop_id};
    if (header.chromaticities) {
        std::string bytes;
        for (const float number : *header.chromaticities) put_float(bytes, number);
        attributes["chromaticities"] = {"chromaticities", std::move(bytes)};
    }
    for (const auto& [name, value] : header.nacre) attributes["nacre:" + name] = {"string", value};
    return attributes;
}

std::string file_header(const Image<Rgb>& image, PixelFormat format, const LutHeader& header) {
    constexpr std::uint32_t magic = 20000630;
    constexpr std::uint32_t version = 2;
    constexpr std::uint32_t long_names = 0x400;  // where a name has more than 31 characters
    const auto attributes = attributes_of(image, format, header);
    std::string bytes;
    put(bytes, magic);
    std::uint32_t flags = version;
    for (const auto& [name, attribute] : attributes) {
        if (name.size() > 31) flags |= long_names;
    }
    put(bytes, flags);
    for (const auto& [name, attribute] : attributes) {
        bytes += name + '\0';
        bytes += std::string(attribute.type) + '\0';
        put(bytes, static_cast<std::uint32_t>(attribute.value.size()));
        bytes += attribute.value;
    }
    return bytes + '\0';
}

void put_row(std::string& bytes, const Image<Rgb>& image, int y, PixelFormat format) {
    for (double Rgb::*component : {&Rgb::b, &Rgb::g, &Rgb::r}) {
        for (int x = 0; x < image.width(); ++x) {
            const auto value = static_cast<float>(image.at(x, y).*component);
            if (format == PixelFormat::half_float) {
                put(bytes, Imath::half(value).bits());
            } else {
                put_float(bytes, value);
            }
        }
    }
}

}  // namespace

std::string plain_exr(const Image<Rgb>& image, PixelFormat format, const LutHeader& header) {
    check_storable(image, format);
    std::string bytes = file_header(image, format, header);
    const std::size_t component = format == PixelFormat::half_float ? 2 : 4;
    const std::size_t row = static_cast<std::size_t>(image.width()) * 3 * component;
    constexpr std::size_t row_head = 8;  // y, and the size of its pixels
    const std::size_t first = bytes.size() + static_cast<std::size_t>(image.height()) * sizeof(std::uint64_t);
    for (int y = 0; y < image.height(); ++y)
        put(bytes, static_cast<std::uint64_t>(first + static_cast<std::size_t>(y) * (row_head + row)));
    for (int y = 0; y < image.height(); ++y) {
        put(bytes, static_cast<std::uint32_t>(y));
        put(bytes, static_cast<std::uint32_t>(row));
        put_row(bytes, image, y, format);
    }
    return bytes;
}

}  // namespace nacre
