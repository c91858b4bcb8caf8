#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>

#include "io/disk/hash.h"
#include "io/ocio/ocio_detail.h"
#include "nacre/base/error.h"

namespace nacre {
namespace {

// A file of the user's own that only this process reads, gone when the scope ends.
class TemporaryFile {
public:
    TemporaryFile(const std::string& text, const std::string& where) {
        std::error_code failure;
        const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
        // OpenColorIO caches files by name, for ever: the content is part of it.
        path_ = (folder / ("nacre-" + hash_text(text) + "-XXXXXX.ctf")).string();
        const int file = failure ? -1 : mkstemps(path_.data(), 4);
        if (file < 0) throw IoError(where + ": cannot make a temporary file; is $TMPDIR right?");
        std::size_t written = 0;
        while (written < text.size()) {
            const ssize_t n = ::write(file, text.data() + written, text.size() - written);
            if (n <= 0) break;
            written += static_cast<std::size_t>(n);
        }
        const bool closed = ::close(file) == 0;
        if (written < text.size() || !closed) {
            ::unlink(path_.c_str());
            throw IoError(where + ": cannot write a temporary file in \"" + folder.string() + "\"; is the disk full?");
        }
    }
    ~TemporaryFile() { ::unlink(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

// OpenColorIO's text says what it tried, and names the temporary file, which has no meaning for the user.
std::string without(std::string message, const std::string& path) {
    const std::string preamble = "Error is:";
    if (const auto at = message.find(preamble); at != std::string::npos) message.erase(0, at + preamble.size());
    for (auto at = message.find(path); at != std::string::npos; at = message.find(path)) {
        message.replace(at, path.size(), "the text");
    }
    return message;
}

}  // namespace

std::string write_ctf(const OCIO::ConstConfigRcPtr& config, const OCIO::GroupTransformRcPtr& group) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    group->write(config, "Color Transform Format", text);
    return text.str();
}

Conversion read_ctf(const std::string& text, const std::string& where) {
    const TemporaryFile file(text, where);
    try {
        auto transform = OCIO::FileTransform::Create();
        transform->setSrc(file.path().c_str());
        Conversion conversion = make_conversion(OCIO::Config::CreateRaw(), transform);
        conversion.ctf = text;
        return conversion;
    } catch (const OCIO::Exception& e) {
        throw Error(where + ": OpenColorIO refuses the transform: " + one_line(without(e.what(), file.path())) +
                    "; it must be a CTF");
    }
}

Conversion make_conversion_with_ctf(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform,
                                    const std::string& where) {
    const auto lossless = config->getProcessor(transform)->getOptimizedProcessor(OCIO::OPTIMIZATION_LOSSLESS);
    Conversion conversion = make_conversion(config, transform);
    if (!conversion.matrix) {
        // Tables lose their last bit in the text. Reading it back makes the applied transform the same as the stored
        // one.
        return read_ctf(write_ctf(config, lossless->createGroupTransform()), where);
    }
    auto carried = OCIO::GroupTransform::Create();
    carried->appendTransform(matrix_transform(*conversion.matrix));
    conversion.ctf = write_ctf(config, carried);
    return conversion;
}

}  // namespace nacre
