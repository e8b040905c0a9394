#pragma once
/// Helpers that the benchmarks share.
#include <algorithm>
#include <chrono>
#include <vector>

#include "throughput/clocks.hpp"

namespace tyndall::bench {

/// Seconds that `work` takes by the clock on the wall.
template <typename Work>
double seconds_of(Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of processor time that `work` takes. With one working thread that is the time on the wall of a machine that has nothing else to
/// do.
template <typename Work>
double processor_seconds_of(Work&& work)
{
    const double start = processor_seconds();
    work();
    return processor_seconds() - start;
}

inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Gives PoCL that many workers, unless the environment says otherwise. Before the first OpenCL call.
void use_workers(int threads);

/// Restricts the process to as many cores.
void stay_on_cores(int cores);

}  // namespace tyndall::bench
