#pragma once
/// The OpenCL side of Device and the helpers that stages share; only files below host/device include this, and bench/transmittance.
#include <future>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "device/device.hpp"
#include "device/opencl.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

struct DeviceState {
    DeviceInfo info;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;  ///< in order, with time stamps where the device has them
    bool time_stamps = true;
    bool native_kernels = false;  ///< runs functions of the host among its commands, in their address space
    double launch_seconds = .1;  ///< launches aim at less
    std::string dump_folder;     ///< for sources of programs; empty: none
    std::mutex guard;                             ///< of `programs`
    std::map<std::string, std::shared_future<cl::Program>> programs;  ///< built or being built in this process, by options and text
};

/// Errors that may vanish with less at a time: memory, resources, a buffer larger than the device allows.
inline bool is_shortage(int code)
{
    return code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES || code == CL_OUT_OF_HOST_MEMORY || code == CL_INVALID_BUFFER_SIZE || code == CL_MAP_FAILURE;
}

/// In order, with time stamps if the device's first queue has them.
cl::CommandQueue another_queue(DeviceState& state);

/// Runs `call`; an OpenCL error becomes a DeviceError (a ResourceError if it is a shortage) that says what was being done, on which device, and what to try.
template <typename Call>
auto on_device(const DeviceState& state, const char* doing, Call&& call)
{
    try {
        return call();
    } catch (const cl::Error& error) {
        const std::string what = state.info.platform + ": " + state.info.name + ": " + doing + " failed in " + error.what() + " with " + opencl_error_name(error.err()) +
                                 "; try a smaller --tile, fewer --lights, or another --device";
        if (is_shortage(error.err())) throw ResourceError(what);
        throw DeviceError(what);
    }
}

/// Compiles a flattened kernel, once for each text and options. May be called from several threads. Throws BuildError with device, options and the compiler's log, and
/// IoError if the source was to be written (Device::dump_kernels) and could not be.
cl::Program build_program(DeviceState& state, const std::string& text, const std::string& options);

/// `wanted` work-items per group, or 1 where the device does not run so many of this kernel.
inline std::uint32_t local_size(const DeviceState& state, const cl::Kernel& kernel, std::uint32_t wanted)
{
    return kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(state.device) >= wanted ? wanted : 1;
}

/// A device buffer of bytes that grows, and shrinks only when it is released.
class GrowingBuffer {
public:
    explicit GrowingBuffer(cl_mem_flags flags) : flags_(flags) {}
    /// At least `bytes` large (never 0). Contents are lost when it grows.
    cl::Buffer& reserve(DeviceState& state, std::size_t bytes);
    cl::Buffer& upload(DeviceState& state, std::span<const std::byte> bytes);
    cl::Buffer& get() { return buffer_; }
    const cl::Buffer& get() const { return buffer_; }
    void release() { buffer_ = cl::Buffer(), size_ = 0; }

private:
    cl_mem_flags flags_;
    cl::Buffer buffer_;
    std::size_t size_ = 0;
};

}  // namespace tyndall
