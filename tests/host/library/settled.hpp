#pragma once
/// Numbers of references to OpenCL objects, which drivers let go of in their own time.
#include <CL/cl.h>

#include <chrono>
#include <functional>
#include <thread>

namespace tyndall::test {

/// What `count` comes to: a driver's own threads may hold what they have finished for a moment longer.
inline cl_uint settled(const std::function<cl_uint()>& count, cl_uint expected)
{
    for (int i = 0; i < 1000 && count() != expected; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return count();
}

}  // namespace tyndall::test
