#include "cli/stop_signal.h"

#include <csignal>

namespace nacre {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

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
    if (caught_signal != 0) throw StopRequested{caught_signal};
}

}  // namespace nacre
