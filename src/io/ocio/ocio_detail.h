#pragma once

// Internal to the OpenColorIO room (colour_*.cpp, known_spaces.*, ocio_detail.*): these headers show OpenColorIO.

#include <OpenColorIO/OpenColorIO.h>

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "io/ocio/colour_transform.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

namespace OCIO = OCIO_NAMESPACE;

/// Turns off OpenColorIO's logging, once for the process, because stderr belongs to nacre.
void silence_ocio();

/// OpenColorIO's messages run over several lines: white space collapsed, control characters gone, at most 300 bytes.
std::string one_line(std::string_view message);

/// A finished conversion XYZ -> RGB. `cpu` always holds it; `matrix` too, when it is nothing else.
struct Conversion {
    OCIO::ConstCPUProcessorRcPtr cpu;
    std::optional<glm::dmat3> matrix;
    std::string ctf;                         ///< empty unless made by make_conversion_with_ctf()
    OCIO::ConstCPUProcessorRcPtr back = {};  ///< RGB -> XYZ; null for a matrix, and where OpenColorIO has no inverse
};

/// @throws OCIO::Exception
Conversion make_conversion(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform);

/// The same with its CTF, and exactly what read_ctf() makes of that. Uses a temporary file unless it is a matrix.
/// @throws OCIO::Exception, Error, IoError
Conversion make_conversion_with_ctf(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform,
                                    const std::string& where);
/// @throws Error if OpenColorIO refuses the text, IoError if there is no place for a temporary file
Conversion read_ctf(const std::string& text, const std::string& where);

/// Whether convert_back() can be called.
bool has_way_back(const Conversion& conversion);
/// The inverse of convert(), as exactly as OpenColorIO provides it.
/// @throws Error naming `target` and the first pixel that is not finite
Image<Xyz> convert_back(const Conversion& conversion, const Image<Rgb>& image, const std::string& target);

/// Converts in double by the matrix, else in float by OpenColorIO.
/// @throws Error naming `target` and the first pixel that is not finite
Image<Rgb> convert(const Conversion& conversion, const Image<Xyz>& image, const std::string& target);

OCIO::MatrixTransformRcPtr matrix_transform(const glm::dmat3& matrix);

struct ColourTransform::Impl {
    Conversion conversion;
    std::string target;
    std::string display;
    std::string view;
    std::string interop_id;
};

}  // namespace nacre
