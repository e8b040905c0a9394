#pragma once
/// What time is measured with.
#include <functional>
#include <memory>

namespace tyndall {

/// Seconds since some moment.
using Clock = std::function<double()>;

/// Processor time of all threads of this process. With one working thread that is the time on the wall of a machine that has nothing else to do.
double processor_seconds();

/// Time on the wall.
double wall_seconds();

/// As long as it lives, this thread and those that it starts stay on one core, and PoCL has one worker unless the environment says otherwise. Devices that are opened
/// meanwhile keep to it: make one before the first OpenCL call, and let go of it afterwards.
class OneCore {
public:
    OneCore();
    ~OneCore();
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

private:
    struct Mask;
    std::unique_ptr<Mask> before_;
};

}  // namespace tyndall
