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
    std::mutex guard;                             ///< of `programs`
    std::map<std::string, std::shared_future<cl::Program>> programs;  ///< built or being built in this process, by options and text
};

/// Runs `call`; an OpenCL error becomes a DeviceError that says what was being done, on which device, and what to try.
template <typename Call>
auto on_device(const DeviceState& state, const char* doing, Call&& call)
{
    try {
        return call();
    } catch (const cl::Error& error) {
        throw DeviceError(state.info.platform + ": " + state.info.name + ": " + doing + " failed in " + error.what() + " with " + opencl_error_name(error.err()) +
                          "; try a smaller --tile, fewer --lights, or another --device");
    }
}

/// Compiles a flattened kernel, once for each text and options. May be called from several threads. Throws BuildError with device, options and the compiler's log.
cl::Program build_program(DeviceState& state, const std::string& text, const std::string& options);

/// A device buffer of bytes that grows and never shrinks.
class GrowingBuffer {
public:
    explicit GrowingBuffer(cl_mem_flags flags) : flags_(flags) {}
    /// At least `bytes` large (never 0). Contents are lost when it grows.
    cl::Buffer& reserve(DeviceState& state, std::size_t bytes);
    cl::Buffer& upload(DeviceState& state, std::span<const std::byte> bytes);
    cl::Buffer& get() { return buffer_; }

private:
    cl_mem_flags flags_;
    cl::Buffer buffer_;
    std::size_t size_ = 0;
};

}  // namespace tyndall
