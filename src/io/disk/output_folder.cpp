#include "io/disk/output_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include "io/disk/hash.h"
#include "nacre/base/error.h"

namespace nacre {
namespace {

// Up to this many files are flushed one by one; for more, one flush of the file system is cheaper.
constexpr std::size_t few_files = 8;

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
    throw IoError(path + ": cannot " + what + ": " + std::strerror(error));
}

// Closes at the end of a scope; close() itself is checked, because that is where a network disk reports its errors.
class Descriptor {
public:
    explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
    ~Descriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return descriptor_; }
    int close() { return ::close(std::exchange(descriptor_, -1)); }

private:
    int descriptor_;
};

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) fail(path, "be written", count < 0 ? errno : ENOSPC);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

// Nothing if there is no such file, or it is not a plain readable one.
std::optional<std::string> read_all(int folder, const std::string& name) {
    const Descriptor file(::openat(folder, name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(file.get(), bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return std::nullopt;
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

// Different from the name of any other process, and from files left by a killed process with the same number.
std::string unique_prefix() {
    return ".nacre-" + std::to_string(::getpid()) + "-" + std::to_string(std::random_device{}()) + "-";
}

}  // namespace

OutputFolder::OutputFolder(std::string path) : path_(path.empty() ? "." : std::move(path)) {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    std::error_code ignored;
    if (error && !std::filesystem::is_directory(path_, ignored))
        throw IoError(path_ + ": cannot be created: " + error.message());
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) fail(path_, "be opened as a folder", errno);
}

OutputFolder::~OutputFolder() {
    for (const Pending& file : pending_) ::unlinkat(descriptor_, file.temporary.c_str(), 0);
    ::close(descriptor_);
}

std::string OutputFolder::full_path(const std::string& name) const {
    return (std::filesystem::path(path_) / name).string();
}

bool OutputFolder::holds(const std::string& name, std::string_view bytes) const {
    struct stat status {};
    if (::fstatat(descriptor_, name.c_str(), &status, 0) != 0 ||
        static_cast<std::size_t>(status.st_size) != bytes.size())
        return false;
    const auto present = read_all(descriptor_, name);
    return present && *present == bytes;
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    static const std::string prefix = unique_prefix();
    Pending pending{name, {}, hash_of(bytes), bytes.size()};
    {
        const std::lock_guard lock(mutex_);
        pending.temporary = prefix + std::to_string(next_++) + ".tmp";
        pending_.push_back(pending);
    }
    Descriptor file(::openat(descriptor_, pending.temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0) fail(full_path(name), "be written", errno);
    write_all(file.get(), bytes, full_path(name));
    if (file.close() != 0) fail(full_path(name), "be written", errno);
}

void OutputFolder::make_durable(const std::vector<Pending>& files) const {
    if (files.size() > few_files) {
        if (::syncfs(descriptor_) != 0) fail(path_, "be flushed to the disk", errno);
        return;
    }
    for (const Pending& pending : files) {
        const Descriptor file(::openat(descriptor_, pending.temporary.c_str(), O_RDONLY | O_CLOEXEC));
        if (file.get() < 0 || ::fsync(file.get()) != 0) fail(full_path(pending.name), "be flushed to the disk", errno);
    }
}

void OutputFolder::read_back(const Pending& file) const {
    const auto bytes = read_all(descriptor_, file.temporary);
    if (!bytes || bytes->size() != file.size || hash_of(*bytes) != file.hash) {
        throw IoError(full_path(file.name) + ": the file does not read back as it was written; is the disk full?");
    }
}

void OutputFolder::commit() {
    const std::lock_guard lock(mutex_);
    if (pending_.empty()) return;
    make_durable(pending_);
    for (const Pending& file : pending_) read_back(file);
    while (!pending_.empty()) {
        const Pending& file = pending_.back();
        if (::renameat(descriptor_, file.temporary.c_str(), descriptor_, file.name.c_str()) != 0) {
            fail(full_path(file.name), "be put into place", errno);
        }
        pending_.pop_back();
    }
    if (::fsync(descriptor_) != 0) fail(path_, "be flushed to the disk", errno);
    // A deleted folder still accepts files through its descriptor, but no one would see them.
    struct stat here {};
    struct stat there {};
    if (::fstat(descriptor_, &here) != 0 || ::stat(path_.c_str(), &there) != 0 || here.st_ino != there.st_ino ||
        here.st_dev != there.st_dev) {
        throw IoError(path_ + ": the folder disappeared while its files were written");
    }
}

}  // namespace nacre
