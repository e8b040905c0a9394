#pragma once
/// Ctrl-C and friends: the first signal abandons the pass in progress, so that the passes before it are written; the second one ends the program at once, after removing
/// unfinished files. Before the first pass there is nothing to write, and the first signal ends the program. SIGUSR1 asks for the image and the checkpoint now.
#include "tyndall/stop.hpp"

namespace tyndall {

/// From construction to destruction SIGINT, SIGTERM, SIGHUP and SIGUSR1 are handled. One at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// The first signal that came to stop, or 0.
    int signal() const;
    /// Raised by that signal.
    const StopFlag& stop() const;
    /// From now on there is something to write before the end.
    void expect_writing();
    /// Did SIGUSR1 come since the last call?
    bool take_request();
};

/// Opens the standard streams that the process was started without, as /dev/null: otherwise the next file that is opened would get the number, and what people are told would be written into it. Standard
/// output cannot be written then, which is an error as soon as there are data for it.
void hold_standard_streams();

/// Makes writing beyond a file size limit and to a closed pipe an error that is reported, rather than the end of the process.
void report_write_signals_as_errors();

}  // namespace tyndall
