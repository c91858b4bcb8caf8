#include "cli/console.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "nacre/base/error.h"

namespace nacre {
namespace {

constexpr std::size_t bar_width = 40;

void write_out(std::string_view line) {
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
    if (std::ferror(stdout) != 0)
        throw IoError(std::string("standard output cannot be written: ") + std::strerror(errno));
}

}  // namespace

void Console::result(std::string_view line) {
    const std::lock_guard lock(mutex_);
    clear_progress();
    write_out(line);
}

void Console::result_json(const Json& json) {
    result(json.text());
}

void Console::summary(std::string_view line) {
    if (!options_.json && !options_.quiet) result(line);
}

void Console::note(std::string_view line) {
    if (options_.verbose && !options_.quiet) say(line);
}

void Console::warning(std::string_view message) {
    if (!options_.quiet) say_lines("nacre: warning: ", message);
}

void Console::error(std::string_view message) {
    say_lines("nacre: ", message);
}

void Console::say_lines(std::string_view prefix, std::string_view message) {
    std::size_t begin = 0;
    while (begin <= message.size()) {
        const std::size_t end = std::min(message.find('\n', begin), message.size());
        say(std::string(prefix) + std::string(message.substr(begin, end - begin)));
        begin = end + 1;
    }
}

void Console::say(std::string_view line) {
    const std::lock_guard lock(mutex_);
    clear_progress();
    std::string shown(line);
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';  // a hostile file's words may hold escape codes
    }
    std::fprintf(stderr, "%s\n", shown.c_str());
}

void Console::progress(std::size_t done, std::size_t total) {
    static const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
    if (!on_terminal || options_.quiet || options_.json || total < 2) return;
    const std::lock_guard lock(mutex_);
    const std::size_t filled = bar_width * done / total;
    const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
    std::fprintf(stderr, "\r[%s] %zu of %zu", bar.c_str(), done, total);
    std::fflush(stderr);
    bar_shown_ = true;
    if (done == total) clear_progress();
}

void Console::clear_progress() {
    if (!bar_shown_) return;
    std::fputs("\r\033[K", stderr);
    bar_shown_ = false;
}

void Console::finish() {
    const std::lock_guard lock(mutex_);
    clear_progress();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw IoError(std::string("standard output cannot be written: ") + std::strerror(errno));
    }
}

}  // namespace nacre
