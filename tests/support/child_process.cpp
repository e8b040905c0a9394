#include "child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

namespace tyndall::test {
namespace {

constexpr auto poll_interval = std::chrono::milliseconds(5);

void redirect(const char* file, int flags, int descriptor)
{
    const int opened = ::open(file, flags, 0600);
    if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(127);
    ::close(opened);
}

/// In the child: everything that precedes exec.
void prepare(const ProcessSetup& setup, const std::string& own, const std::string& out, const std::string& err)
{
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ, SIGPIPE}) ::signal(number, SIG_DFL);  // a test runner may ignore some
    if (!setup.folder.empty() && ::chdir(setup.folder.c_str()) != 0) ::_exit(127);
    ::setenv("XDG_CONFIG_HOME", own.c_str(), 1);  // the user's calibrations are nothing to a test
    for (const auto& [name, value] : setup.environment) ::setenv(name.c_str(), value.c_str(), 1);
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect(setup.standard_output ? setup.standard_output->c_str() : out.c_str(), O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(setup.standard_error ? setup.standard_error->c_str() : err.c_str(), O_WRONLY | O_CREAT, STDERR_FILENO);
    if (setup.file_size_limit) {
        const rlimit limit{*setup.file_size_limit, *setup.file_size_limit};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(127);
    }
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const ProcessSetup& setup)
{
    const std::string out = (captured_ / "out").string(), err = (captured_ / "err").string();
    std::vector<char*> pointers;
    for (const auto& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    process_ = ::fork();
    if (process_ < 0) throw std::runtime_error("fork failed");
    if (process_ > 0) return;
    prepare(setup, captured_.path().string(), out, err);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
}

ChildProcess::~ChildProcess()
{
    if (ended()) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
}

bool ChildProcess::ended()
{
    int status = 0;
    if (!status_ && ::waitpid(process_, &status, WNOHANG) == process_) status_ = status;
    return status_.has_value();
}

bool ChildProcess::wait_for_error_text(const std::string& text, std::chrono::seconds limit)
{
    const auto end = std::chrono::steady_clock::now() + limit;
    while (std::chrono::steady_clock::now() < end) {
        if (file_bytes(captured_ / "err").find(text) != std::string::npos) return true;
        if (ended()) return false;
        std::this_thread::sleep_for(poll_interval);
    }
    return false;
}

void ChildProcess::send(int signal) const { ::kill(process_, signal); }

ProcessResult ChildProcess::wait(std::chrono::seconds limit)
{
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!ended()) {
        if (std::chrono::steady_clock::now() > end) ::kill(process_, SIGKILL);
        std::this_thread::sleep_for(poll_interval);
    }
    ProcessResult result{.out = file_bytes(captured_ / "out"), .err = file_bytes(captured_ / "err")};
    if (WIFEXITED(*status_))
        result.exit_code = WEXITSTATUS(*status_);
    else
        result.signal = WTERMSIG(*status_);
    return result;
}

ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessSetup& setup)
{
    return ChildProcess(arguments, setup).wait();
}

std::string file_bytes(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace tyndall::test
