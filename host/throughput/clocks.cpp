#include "throughput/clocks.hpp"

#include <sched.h>
#include <stdlib.h>
#include <time.h>

namespace tyndall {
namespace {

double seconds_of(clockid_t clock)
{
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

struct OneCore::Mask {
    cpu_set_t cores;
};

OneCore::OneCore() : before_(std::make_unique<Mask>())
{
    setenv("POCL_MAX_PTHREAD_COUNT", "1", 0);
    if (sched_getaffinity(0, sizeof before_->cores, &before_->cores) != 0) {
        before_.reset();
        return;
    }
    cpu_set_t first;
    CPU_ZERO(&first);
    for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&first) == 0; ++core)
        if (CPU_ISSET(core, &before_->cores)) CPU_SET(core, &first);
    sched_setaffinity(0, sizeof first, &first);
}

OneCore::~OneCore()
{
    if (before_) sched_setaffinity(0, sizeof before_->cores, &before_->cores);
}

}  // namespace tyndall
