#pragma once
/// How the program ends. Scripts and farm managers rely on these numbers: they never change their meaning.
namespace tyndall {

enum class ExitCode : int {
    ok = 0,
    internal = 1,            ///< a mistake in Tyndall, or out of memory
    usage = 2,               ///< command line
    input = 3,               ///< scene or another input is invalid
    no_device = 4,           ///< no usable OpenCL device
    device_failed = 5,       ///< a device failed while it was used, or its compiler
    output = 6,              ///< not written
    target_not_reached = 7,  ///< finished, but the target error was not reached in the budget
    outside_tolerance = 8,   ///< compare, selftest
    temporary = 75,          ///< a retry helps
};
/// After a signal: 128 + its number (130 SIGINT, 143 SIGTERM, 129 SIGHUP).
inline constexpr int exit_after_signal = 128;

/// Prints the exception that is being handled to stderr as one sentence and returns its exit code. Call inside a catch block.
int report_failure() noexcept;

}  // namespace tyndall
