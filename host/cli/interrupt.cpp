#include "cli/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <optional>

#include "cli/exit_code.hpp"
#include "film/atomic_file.hpp"

namespace tyndall {
namespace {

constexpr std::array handled{SIGINT, SIGTERM, SIGHUP, SIGUSR1};
std::atomic<int> first_signal{0};
std::atomic<bool> something_to_write{false}, requested{false};
StopFlag* stop_flag = nullptr;  ///< of the guard that there is
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void on_signal(int number)
{
    if (number == SIGUSR1) {
        requested = true;
        return;
    }
    int none = 0;
    if (first_signal.compare_exchange_strong(none, number) && something_to_write) {
        stop_flag->raise();
        static constexpr char text[] = "\nstopping and writing what is there; once more to stop at once and write nothing\n";
        [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, text, sizeof text - 1);
        return;
    }
    AtomicFile::remove_unfinished();
    ::_exit(exit_after_signal + number);
}

/// What was there before; the guard puts it back.
std::array<struct sigaction, handled.size()> previous;

void install(int number, struct sigaction& before)
{
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) ::sigaction(number, &action, nullptr);  // ignored on purpose, as under nohup: stays so
}

}  // namespace

InterruptGuard::InterruptGuard()
{
    static std::optional<StopFlag> flag;
    flag.emplace();
    stop_flag = &*flag;
    first_signal = 0, something_to_write = false, requested = false;
    for (std::size_t i = 0; i < handled.size(); ++i) install(handled[i], previous[i]);
}

InterruptGuard::~InterruptGuard()
{
    for (std::size_t i = 0; i < handled.size(); ++i) ::sigaction(handled[i], &previous[i], nullptr);
}

int InterruptGuard::signal() const { return first_signal; }

const StopFlag& InterruptGuard::stop() const { return *stop_flag; }

void InterruptGuard::expect_writing() { something_to_write = true; }

bool InterruptGuard::take_request() { return requested.exchange(false); }

void hold_standard_streams()
{
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) [[maybe_unused]] const int lowest = ::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

void report_write_signals_as_errors()
{
    ::signal(SIGXFSZ, SIG_IGN);
    ::signal(SIGPIPE, SIG_IGN);
}

}  // namespace tyndall
