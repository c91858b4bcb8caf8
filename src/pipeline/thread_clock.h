#pragma once

#include <ctime>

namespace nacre {

/// Seconds that this thread has computed: what other threads and programs took of the machine is not in it.
inline double thread_seconds() {
    timespec time{};
#ifdef __EMSCRIPTEN__
    ::clock_gettime(CLOCK_MONOTONIC, &time);  // WebAssembly has no clock of a thread
#else
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
#endif
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace nacre
