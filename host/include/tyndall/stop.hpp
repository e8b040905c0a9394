#pragma once
/// Stopping a render from another thread or a signal handler.
#include <atomic>

#include "tyndall/error.hpp"

namespace tyndall {

/// Raised once; loops of a pass look at it every few milliseconds of work.
class StopFlag {
public:
    /// Safe in a signal handler.
    void raise() noexcept { raised_.store(true, std::memory_order_relaxed); }
    bool raised() const noexcept { return raised_.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> raised_{false};
    static_assert(std::atomic<bool>::is_always_lock_free);
};

/// A pass was abandoned because its flag was raised. It never leaves `render`.
struct Stopped : Error {
    Stopped() : Error("stopped") {}
};

/// Throws Stopped if there is a flag and it is raised.
inline void throw_if_raised(const StopFlag* stop)
{
    if (stop && stop->raised()) throw Stopped();
}

}  // namespace tyndall
