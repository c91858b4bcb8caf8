#include "io/ocio/ocio_detail.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/matrix.hpp>
#include <vector>

#include "nacre/base/error.h"

namespace nacre {
namespace {

// What OpenColorIO writes into a CTF. Rounding here makes the matrix in memory the one in the file.
double round_to_15_digits(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.14e", value);
    return std::strtod(text.data(), nullptr);
}

// The product of a group that holds nothing but matrices without offsets and without an effect on alpha.
std::optional<glm::dmat3> matrix_of(const OCIO::ConstGroupTransformRcPtr& group) {
    glm::dmat3 product(1.0);
    for (int i = 0; i < group->getNumTransforms(); ++i) {
        const auto step = OCIO::DynamicPtrCast<const OCIO::MatrixTransform>(group->getTransform(i));
        if (!step || step->getDirection() != OCIO::TRANSFORM_DIR_FORWARD) return std::nullopt;
        std::array<double, 16> m{};
        std::array<double, 4> offset{};
        step->getMatrix(m.data());
        step->getOffset(offset.data());
        if (offset != std::array<double, 4>{} || m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0) return std::nullopt;
        // OpenColorIO prints rows, glm stores columns.
        product = glm::dmat3(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]) * product;
    }
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) product[column][row] = round_to_15_digits(product[column][row]);
    }
    return product;
}

std::string pixel_text(double a, double b, double c) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "(%g, %g, %g)", a, b, c);
    return text.data();
}

// Beyond float's range OpenColorIO would see infinity.
bool fits_float(double value) {
    return std::abs(value) <= double{FLT_MAX};
}

// Null where a step cannot be undone.
OCIO::ConstCPUProcessorRcPtr processor_back(const OCIO::ConstConfigRcPtr& config,
                                            const OCIO::ConstProcessorRcPtr& processor) {
    try {
        const auto back = config->getProcessor(processor->createGroupTransform(), OCIO::TRANSFORM_DIR_INVERSE);
        return back->getOptimizedCPUProcessor(OCIO::OPTIMIZATION_LOSSLESS);
    } catch (const OCIO::Exception&) {
        return {};
    }
}

template <typename Pixel>
[[noreturn]] void throw_not_finite(const Image<Pixel>& image, std::size_t index, const std::string& what,
                                   const std::string& value) {
    const auto width = static_cast<std::size_t>(image.width());
    throw Error(what + ": pixel (" + std::to_string(index % width) + ", " + std::to_string(index / width) + ") is " +
                value + "; only finite numbers are allowed");
}

}  // namespace

void silence_ocio() {
    static const bool once = [] {
        OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
        return true;
    }();
    static_cast<void>(once);
}

std::string one_line(std::string_view message) {
    constexpr std::size_t longest = 300;
    std::string result;
    for (const char c : message) {
        const bool blank = static_cast<unsigned char>(c) <= ' ' || c == 0x7f;
        if (!blank) result += c;
        if (blank && !result.empty() && result.back() != ' ') result += ' ';
        if (result.size() >= longest) {
            // Not in the middle of a UTF-8 sequence.
            while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xc0U) == 0x80U) result.pop_back();
            result.pop_back();
            return result + "...";
        }
    }
    while (!result.empty() && (result.back() == ' ' || result.back() == '.')) result.pop_back();
    return result;
}

Conversion make_conversion(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform) {
    const auto lossless = config->getProcessor(transform)->getOptimizedProcessor(OCIO::OPTIMIZATION_LOSSLESS);
    Conversion conversion{lossless->getOptimizedCPUProcessor(OCIO::OPTIMIZATION_LOSSLESS),
                          matrix_of(lossless->createGroupTransform()),
                          {}};
    if (!conversion.matrix) conversion.back = processor_back(config, lossless);
    return conversion;
}

bool has_way_back(const Conversion& conversion) {
    return conversion.back || (conversion.matrix && glm::determinant(*conversion.matrix) != 0.0);
}

Image<Xyz> convert_back(const Conversion& conversion, const Image<Rgb>& image, const std::string& target) {
    Image<Xyz> result(image.width(), image.height());
    Xyz* out = result.data();
    if (conversion.matrix) {
        const glm::dmat3 back = glm::inverse(*conversion.matrix);
        for (const Rgb& pixel : image) {
            const glm::dvec3 xyz = back * glm::dvec3(pixel.r, pixel.g, pixel.b);
            *out++ = {xyz.x, xyz.y, xyz.z};
        }
        return result;
    }
    if (image.size() == 0) return result;
    std::vector<float> packed;
    packed.reserve(3 * image.size());
    for (const Rgb& pixel : image) {
        for (const double v : {pixel.r, pixel.g, pixel.b}) packed.push_back(static_cast<float>(v));
    }
    OCIO::PackedImageDesc desc(packed.data(), image.width(), image.height(), 3);
    conversion.back->apply(desc);
    for (std::size_t i = 0; i < image.size(); ++i) {
        out[i] = {double{packed[3 * i]}, double{packed[3 * i + 1]}, double{packed[3 * i + 2]}};
        if (!fits_float(out[i].x) || !fits_float(out[i].y) || !fits_float(out[i].z)) {
            throw_not_finite(result, i, "XYZ on the way back from \"" + target + "\"",
                             pixel_text(out[i].x, out[i].y, out[i].z));
        }
    }
    return result;
}

Image<Rgb> convert(const Conversion& conversion, const Image<Xyz>& image, const std::string& target) {
    const Xyz* in = image.data();
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!fits_float(in[i].x) || !fits_float(in[i].y) || !fits_float(in[i].z)) {
            throw_not_finite(image, i, "XYZ on the way to \"" + target + "\"", pixel_text(in[i].x, in[i].y, in[i].z));
        }
    }
    Image<Rgb> result(image.width(), image.height());
    Rgb* out = result.data();
    if (conversion.matrix) {
        for (std::size_t i = 0; i < image.size(); ++i) {
            const glm::dvec3 rgb = *conversion.matrix * glm::dvec3(in[i].x, in[i].y, in[i].z);
            out[i] = {rgb.x, rgb.y, rgb.z};
        }
        return result;
    }
    if (image.size() == 0) return result;
    std::vector<float> packed;
    packed.reserve(3 * image.size());
    for (const Xyz& pixel : image) {
        for (const double v : {pixel.x, pixel.y, pixel.z}) packed.push_back(static_cast<float>(v));
    }
    OCIO::PackedImageDesc desc(packed.data(), image.width(), image.height(), 3);
    conversion.cpu->apply(desc);
    for (std::size_t i = 0; i < image.size(); ++i) {
        out[i] = {double{packed[3 * i]}, double{packed[3 * i + 1]}, double{packed[3 * i + 2]}};
        if (!fits_float(out[i].r) || !fits_float(out[i].g) || !fits_float(out[i].b)) {
            throw_not_finite(result, i, "RGB that the config makes in \"" + target + "\"",
                             pixel_text(out[i].r, out[i].g, out[i].b));
        }
    }
    return result;
}

OCIO::MatrixTransformRcPtr matrix_transform(const glm::dmat3& m) {
    const std::array<double, 16> rows{m[0][0], m[1][0], m[2][0], 0.0, m[0][1], m[1][1], m[2][1], 0.0,
                                      m[0][2], m[1][2], m[2][2], 0.0, 0.0,     0.0,     0.0,     1.0};
    auto transform = OCIO::MatrixTransform::Create();
    transform->setMatrix(rows.data());
    return transform;
}

}  // namespace nacre
