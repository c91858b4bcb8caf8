#include "io/ocio/colour_transform.h"

#include <cstddef>
#include <utility>

#include "io/ocio/known_spaces.h"
#include "io/ocio/ocio_detail.h"
#include "nacre/base/error.h"

namespace nacre {
ColourTransform::ColourTransform(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Image<Rgb> ColourTransform::to_rgb(const Image<Xyz>& image) const {
    return convert(impl_->conversion, image, impl_->target);
}

bool ColourTransform::has_inverse() const {
    return nacre::has_way_back(impl_->conversion);
}

Image<Xyz> ColourTransform::to_xyz(const Image<Rgb>& image) const {
    return convert_back(impl_->conversion, image, impl_->target);
}

const std::string& ColourTransform::name() const {
    return impl_->target;
}
const std::string& ColourTransform::display() const {
    return impl_->display;
}
const std::string& ColourTransform::view() const {
    return impl_->view;
}
const std::string& ColourTransform::interop_id() const {
    return impl_->interop_id;
}
const std::optional<glm::dmat3>& ColourTransform::linear_matrix() const {
    return impl_->conversion.matrix;
}
const std::string& ColourTransform::transform_text() const {
    return impl_->conversion.ctf;
}

ColourTransform ColourTransform::from_ctf(const std::string& text, const std::string& target_name,
                                          const std::string& where, const std::optional<std::string>& interop_id) {
    silence_ocio();
    constexpr std::size_t longest = std::size_t{64} << 20U;
    if (text.size() > longest) throw Error(where + ": the OCIO transform is longer than 64 MiB; that is the limit");
    // OpenColorIO's reader knows several formats by content; only this one carries everything inside itself.
    if (text.find("<ProcessList") == std::string::npos) {
        throw Error(where + ": the OCIO transform is not a CTF; it must be a ProcessList");
    }
    // OpenColorIO does not tell upper from lower case, and a document type could hide a Reference in an entity.
    std::string lower = text;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower.find("reference") != std::string::npos || lower.find("<!doctype") != std::string::npos) {
        throw Error(where + ": the OCIO transform refers to other files; it must contain everything itself");
    }
    auto impl = std::make_shared<Impl>();
    impl->conversion = read_ctf(text, where);
    impl->target = target_name;
    impl->interop_id = interop_id_of(impl->conversion, OCIO::REFERENCE_SPACE_SCENE);
    const std::string of_display = interop_id_of(impl->conversion, OCIO::REFERENCE_SPACE_DISPLAY);
    if (interop_id && impl->interop_id != *interop_id && of_display == *interop_id) impl->interop_id = of_display;
    return ColourTransform(std::move(impl));
}

}  // namespace nacre
