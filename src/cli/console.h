#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

#include "pipeline/json.h"

namespace nacre {

/// What every command has: where words go and how many of them.
struct ConsoleOptions {
    bool json = false;   ///< results as JSON on standard output
    bool quiet = false;  ///< errors only
    bool verbose = false;
};

/// Results on standard output, everything else on standard error. Safe from several threads.
class Console {
public:
    explicit Console(ConsoleOptions options) : options_(options) {}

    bool json() const { return options_.json; }

    /// A line of the result; throws IoError if standard output cannot take it.
    void result(std::string_view line);
    /// The same for a JSON document.
    void result_json(const Json& json);
    /// A line of the result that --quiet and --json leave out.
    void summary(std::string_view line);
    void note(std::string_view line);  ///< with -v only
    /// Not with --quiet. Of several lines, each has the prefix "nacre: warning: ".
    void warning(std::string_view message);
    /// Of several lines, each has the prefix "nacre: ".
    void error(std::string_view message);

    /// Draws a bar on a terminal, nothing elsewhere.
    void progress(std::size_t done, std::size_t total);
    /// Flushes standard output; throws IoError if something got lost.
    void finish();

private:
    void clear_progress();
    void say(std::string_view line);
    void say_lines(std::string_view prefix, std::string_view message);

    ConsoleOptions options_;
    std::mutex mutex_;
    bool bar_shown_ = false;
};

}  // namespace nacre
