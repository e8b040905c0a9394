#pragma once
/// OpenCL that fails or lies when a test wants it to: functions of the same names in front of the loader's. A test program that links faulty_opencl.cpp gets them; as a library of
/// its own they come first in any program that is started with it in LD_PRELOAD, controlled by TYNDALL_FAULTY_OPENCL="fail_at=7 error=-5 ...".
#include <atomic>
#include <cstddef>
#include <string>

namespace tyndall::test {

struct OpenClFaults {
    std::atomic<long> calls{0};               ///< so far, of those that can fail
    std::atomic<long> fail_at{-1};            ///< the number of the call that fails, from 0; negative: none
    std::atomic<long> failures{1};            ///< so many calls from there on fail
    std::atomic<int> error{-5};               ///< with this code
    std::atomic<std::size_t> largest_buffer{0};  ///< buffers larger than this are refused with CL_INVALID_BUFFER_SIZE; 0: no limit
    std::atomic<std::size_t> memory{0};       ///< buffers beyond so many bytes altogether are refused with CL_MEM_OBJECT_ALLOCATION_FAILURE; 0: no limit
    std::atomic<std::size_t> largest_group{0};   ///< work-items; 0: as it is
    std::atomic<bool> no_profiling{false};    ///< queues without time stamps only
    std::atomic<bool> no_devices{false};      ///< platforms have none
    std::atomic<bool> no_platforms{false};
    std::atomic<bool> queries{false};         ///< calls that only ask count and fail too
    std::atomic<bool> late{false};            ///< a call that fails has done its work all the same
    std::atomic<bool> hang{false};            ///< a call that would fail never returns
    std::atomic<long> poison{-1};             ///< the number of the read, from 0, that gives NaN in place of what the device has; negative: none
    std::atomic<long> reads{0};               ///< so far
    std::atomic<bool> say{false};             ///< a failure is told on standard error
    std::atomic<std::size_t> largest_asked{0};   ///< bytes, of all buffers that were asked for
    std::string failed;                       ///< the function whose call failed last

    void reset();
};

OpenClFaults& opencl_faults();

}  // namespace tyndall::test
