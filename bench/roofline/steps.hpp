#pragma once
/// Counting what a processor executes, without its counters: a child is stepped instruction by instruction through one work-group. Linux on x86-64, PoCL.
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace tyndall::bench {

struct SteppedKernel {
    std::string file;                              ///< the compiled kernel
    std::map<std::uint64_t, std::uint64_t> counts; ///< how often each instruction was executed, by its address in the file
};

/// Forks. In the child, what `prepare` returns runs until it enters the kernel of that name, and from there step by step until the kernel returns. What is prepared must have run before, so that
/// the kernel's code is there, in the thread that calls (PoCL's device "basic"). Throws std::runtime_error.
SteppedKernel step_through(const std::string& kernel, const std::function<std::function<void()>()>& prepare);

}  // namespace tyndall::bench
