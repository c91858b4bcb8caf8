#include "io/image/lut_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <Imath/half.h>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"

namespace nacre {
namespace {

constexpr std::string_view prefix = "nacre:";
constexpr int largest_stored_side = widest_lut_size;

OIIO::ImageSpec make_spec(const Image<Rgb>& image, PixelFormat format, const LutHeader& header) {
    OIIO::ImageSpec spec(image.width(), image.height(), 3,
                         format == PixelFormat::half_float ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "none");
    // OpenImageIO adds the time and its own name by itself; the same scene must give the same bytes.
    spec.attribute("DateTime", "");
    spec.attribute("Software", header.software);
    if (!header.interop_id.empty()) spec.attribute("colorInteropID", header.interop_id);
    if (header.chromaticities) {
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), header.chromaticities->data());
    }
    for (const auto& [name, value] : header.nacre) spec.attribute(std::string(prefix) + name, value);
    return spec;
}

template <typename Component>
std::vector<Component> components(const Image<Rgb>& image) {
    std::vector<Component> result;
    result.reserve(image.size() * 3);
    for (const Rgb& pixel : image) {
        for (const double value : {pixel.r, pixel.g, pixel.b}) {
            result.push_back(static_cast<Component>(static_cast<float>(value)));
        }
    }
    return result;
}

std::string contract_breach(OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.channelnames != std::vector<std::string>{"R", "G", "B"}) return "the channels are not R, G, B";
    if (spec.tile_width != 0) return "the file is tiled; a LUT has scanlines";
    if (spec.get_string_attribute("compression") != "none") return "the file is compressed; a LUT is not";
    if (spec.x != 0 || spec.y != 0 || spec.full_x != 0 || spec.full_y != 0 || spec.full_width != spec.width ||
        spec.full_height != spec.height) {
        return "the data window is not the display window at (0, 0)";
    }
    if (spec.format != OIIO::TypeDesc::HALF && spec.format != OIIO::TypeDesc::FLOAT)
        return "the numbers are not floats";
    if (input.seek_subimage(1, 0)) return "the file has several parts; a LUT has one";
    input.seek_subimage(0, 0);
    return {};
}

}  // namespace

std::string encode_lut(const Image<Rgb>& image, PixelFormat format, const LutHeader& header) {
    check_storable(image, format);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("lut.exr", &memory);
    const auto fail = [&](const char* step) {
        throw IoError(std::string("the EXR encoder cannot ") + step + ": " +
                      (output ? output->geterror() : OIIO::geterror()));
    };
    if (!output) fail("start");
    output->set_ioproxy(&memory);
    if (!output->open("lut.exr", make_spec(image, format, header))) fail("open");
    const bool written = format == PixelFormat::half_float
                             ? output->write_image(OIIO::TypeDesc::HALF, components<Imath::half>(image).data())
                             : output->write_image(OIIO::TypeDesc::FLOAT, components<float>(image).data());
    if (!written) fail("write");
    if (!output->close()) fail("finish");
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void prepare_encoder() {
    encode_lut(Image<Rgb>(1, 1), PixelFormat::half_float, {});
}

StoredLut read_lut(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw IoError(path + ": cannot be read: " + OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    if (std::string_view(input->format_name()) != "openexr")
        throw Error(path + ": is not an EXR file; nacre writes LUTs as EXR");
    if (spec.nchannels != 3 || spec.width < 1 || spec.height < 1 || spec.width > largest_stored_side ||
        spec.height > largest_stored_side) {
        throw Error(path + ": has " + std::to_string(spec.nchannels) + " channels and " + std::to_string(spec.width) +
                    " x " + std::to_string(spec.height) + " texels; a LUT has R, G, B and up to " +
                    std::to_string(largest_stored_side) + " texels a side");
    }
    StoredLut lut;
    lut.breach = contract_breach(*input);
    lut.format = spec.format == OIIO::TypeDesc::HALF ? PixelFormat::half_float : PixelFormat::single_float;
    std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 3);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data()))
        throw IoError(path + ": cannot be read: " + input->geterror());
    lut.image = Image<Rgb>(spec.width, spec.height);
    for (std::size_t i = 0; i < lut.image.size(); ++i)
        lut.image.data()[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    lut.header.software = spec.get_string_attribute("Software");
    lut.header.interop_id = spec.get_string_attribute("colorInteropID");
    std::array<float, 8> chromaticities{};
    if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities.data())) {
        lut.header.chromaticities = chromaticities;
    }
    for (const auto& attribute : spec.extra_attribs) {
        const std::string_view name(attribute.name().data(), attribute.name().size());
        if (name.starts_with(prefix)) lut.header.nacre.emplace_back(name.substr(prefix.size()), attribute.get_string());
    }
    input->close();
    return lut;
}

}  // namespace nacre
