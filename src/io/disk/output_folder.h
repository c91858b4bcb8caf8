#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// A folder in which a file appears complete or not at all.
///
/// write() puts the bytes into a temporary file beside the target; commit() makes all of them durable, reads them back,
/// and renames them into place. Whenever the process is killed, a target is either the old file or the new one. The
/// cost of durability is per commit, not per file. Temporary files that were not committed are removed by the
/// destructor.
///
/// Every failure of the system is an IoError that names the file. write() may be called from several threads at once.
class OutputFolder {
public:
    /// Creates the folder, and those above it, if they are missing.
    explicit OutputFolder(std::string path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Whether the file exists already with exactly these bytes.
    bool holds(const std::string& name, std::string_view bytes) const;

    void write(const std::string& name, std::string_view bytes);

    /// Puts everything written so far into place.
    void commit();

private:
    struct Pending {
        std::string name;
        std::string temporary;
        std::uint64_t hash;
        std::size_t size;
    };

    void make_durable(const std::vector<Pending>& files) const;
    void read_back(const Pending& file) const;
    std::string full_path(const std::string& name) const;

    std::string path_;
    int descriptor_ = -1;  // of the folder itself; it stays valid if the folder is renamed
    mutable std::mutex mutex_;
    std::vector<Pending> pending_;
    std::uint64_t next_ = 0;
};

}  // namespace nacre
