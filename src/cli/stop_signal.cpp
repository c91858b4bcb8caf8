#include "cli/stop_signal.h"

#include <atomic>
#include <csignal>

namespace nacre {
namespace {

std::atomic<int> caught_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes it");

void note_signal(int signal) {
    caught_signal = signal;
}

}  // namespace

void watch_stop_signals() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);
}

void throw_if_stopped() {
    if (const int signal = caught_signal; signal != 0) throw StopRequested{signal};
}

}  // namespace nacre
