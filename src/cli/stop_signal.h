#pragma once

namespace nacre {

/// Thrown between two jobs (LUTs, pictures, files, rows) when the process was asked to end.
struct StopRequested {
    int signal;
};

/// From here on SIGTERM and SIGINT are noted rather than fatal, so that no temporary file stays behind; and a file that
/// grows past a limit is an error of write() rather than the end of the process. A second signal ends it at once.
void watch_stop_signals();

/// Throws StopRequested if a signal has come.
void throw_if_stopped();

}  // namespace nacre
