#pragma once
/// Runs a program as a user would, for tests of the command line.
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "temporary_folder.hpp"

namespace tyndall::test {

struct ProcessSetup {
    std::filesystem::path folder;                                  ///< to run in; empty: here
    std::vector<std::pair<std::string, std::string>> environment;  ///< set or replaced
    std::optional<std::uint64_t> file_size_limit;                  ///< bytes, RLIMIT_FSIZE
    std::optional<std::string> standard_output;                    ///< written here instead of being captured
    std::optional<std::string> standard_error;                     ///< likewise
};

struct ProcessResult {
    int exit_code = -1;  ///< -1 if a signal ended it
    int signal = 0;      ///< that signal
    std::string out, err;
};

class ChildProcess {
public:
    /// Starts arguments[0]; standard input is empty.
    explicit ChildProcess(const std::vector<std::string>& arguments, const ProcessSetup& setup = {});
    /// Kills it if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// True as soon as its standard error holds `text`; false if it ended or the time is up first.
    bool wait_for_error_text(const std::string& text, std::chrono::seconds limit = std::chrono::seconds(60));
    void send(int signal) const;
    /// Waits for its end, but kills it (signal 9 in the result) after the limit.
    ProcessResult wait(std::chrono::seconds limit = std::chrono::seconds(120));

private:
    bool ended();

    TemporaryFolder captured_;
    pid_t process_ = -1;
    std::optional<int> status_;
};

/// Starts and waits.
ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessSetup& setup = {});

/// The bytes of a file; empty if there is none.
std::string file_bytes(const std::filesystem::path& file);

}  // namespace tyndall::test
