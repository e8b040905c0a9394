#pragma once
/// Ctrl-C and friends: the first signal asks for a stop, so that the current pass is finished and written; the second one ends the program
/// at once, after removing unfinished files.
namespace tyndall {

/// From construction to destruction SIGINT, SIGTERM and SIGHUP are handled. One at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// The first signal that came, or 0.
    int signal() const;
};

/// Makes writing beyond a file size limit and to a closed pipe an error that is reported, rather than the end of the process.
void report_write_signals_as_errors();

}  // namespace tyndall
