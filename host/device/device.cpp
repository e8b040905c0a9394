#include "device/device.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <system_error>

#include "device/device_state.hpp"

namespace tyndall {
namespace {

cl::CommandQueue make_queue(DeviceState& state)
{
    try {
        return cl::CommandQueue(state.context, state.device, cl::QueueProperties::Profiling);
    } catch (const cl::Error&) {
        state.time_stamps = false;  // some drivers have none: the report then shows wall-clock times, marked as such
        return cl::CommandQueue(state.context, state.device);
    }
}

bool runs_native_kernels(const DeviceState& state) { return state.info.is_cpu && (state.device.getInfo<CL_DEVICE_EXECUTION_CAPABILITIES>() & CL_EXEC_NATIVE_KERNEL) != 0; }

cl::CommandQueue adopted_queue(DeviceState& state, void* handle)
{
    cl::CommandQueue queue(static_cast<cl_command_queue>(handle), true);
    if (queue.getInfo<CL_QUEUE_CONTEXT>()() != state.context() || queue.getInfo<CL_QUEUE_DEVICE>()() != state.device())
        throw UsageError("the caller's OpenCL queue is not one of the context and the device given with it");
    const cl_command_queue_properties properties = queue.getInfo<CL_QUEUE_PROPERTIES>();
    if (properties & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) throw UsageError("the caller's OpenCL queue is out of order; give one that is in order, or none");
    state.time_stamps = (properties & CL_QUEUE_PROFILING_ENABLE) != 0;
    return queue;
}

}  // namespace

Device::Device(const std::string& request) : state_(std::make_unique<DeviceState>())
{
    state_->info = choose_device(request);
    state_->device = device_at(state_->info.index);
    on_device(*state_, "opening the device", [&] {
        state_->context = cl::Context(state_->device);
        state_->queue = make_queue(*state_);
        state_->native_kernels = runs_native_kernels(*state_);
    });
}

Device::Device(const OpenClHandles& handles) : state_(std::make_unique<DeviceState>())
{
    if (!handles.context || !handles.device) throw UsageError("the caller's OpenCL context and device are both needed; one of them is null");
    state_->device = cl::Device(static_cast<cl_device_id>(handles.device), true);
    state_->info = info_of(state_->device);
    on_device(*state_, "using the caller's context", [&] {
        state_->context = cl::Context(static_cast<cl_context>(handles.context), true);
        const auto devices = state_->context.getInfo<CL_CONTEXT_DEVICES>();
        if (std::none_of(devices.begin(), devices.end(), [&](const cl::Device& d) { return d() == state_->device(); })) throw UsageError("the caller's OpenCL context does not hold the device given with it");
        state_->queue = handles.queue ? adopted_queue(*state_, handles.queue) : make_queue(*state_);
        state_->native_kernels = !handles.queue && runs_native_kernels(*state_);  // a caller's queue stays the only one
    });
}

cl::CommandQueue another_queue(DeviceState& state) { return state.time_stamps ? make_queue(state) : cl::CommandQueue(state.context, state.device); }

Device::~Device() = default;
Device::Device(Device&&) noexcept = default;

const DeviceInfo& Device::info() const { return state_->info; }

void Device::bound_launches(double seconds) { state_->launch_seconds = seconds; }
void Device::dump_kernels(const std::string& folder) { state_->dump_folder = folder; }
bool Device::time_stamps() const { return state_->time_stamps; }

std::uint64_t Device::programs_built() const
{
    const std::lock_guard lock(state_->guard);
    return state_->programs.size();
}

namespace {

/// The source as it goes to the compiler, below a comment that names device and options. `#line` keeps the numbers of lines right.
void dump(const DeviceState& state, const std::string& text, const std::string& options)
{
    const std::filesystem::path folder = state.dump_folder, file = folder / (std::to_string(std::hash<std::string>{}(options + "\n" + text)) + ".cl");
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    std::ofstream stream(file, std::ios::binary);
    stream << "// " << state.info.platform << ": " << state.info.name << "\n// " << options << "\n" << text;
    if (fault || !stream.flush()) throw IoError(file.string() + ": the source of a program could not be written; choose another --dump-kernels");
}

cl::Program compiled(DeviceState& state, const std::string& text, const std::string& wanted)
{
    const std::string options = wanted + state.info.build_options;
    if (!state.dump_folder.empty()) dump(state, text, options);
    cl::Program program = on_device(state, "creating a program", [&] { return cl::Program(state.context, text); });
    const cl_device_id device = state.device();
    const cl_int code = clBuildProgram(program(), 1, &device, options.c_str(), nullptr, nullptr);  // the binding asks for the log, and throws what that returns
    if (code != CL_SUCCESS) {
        std::string log = "(no log)";
        try {
            log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(state.device);
        } catch (const cl::Error&) {
        }
        throw BuildError(state.info.platform + ": " + state.info.name + ": kernels did not compile with " + opencl_error_name(code) + ", options \"" + options +
                         "\":\n" + log + (log.find("error:") == std::string::npos ? "\nthe log names no error in the kernels: does the driver have room and the right to write where it keeps what it builds (PoCL: POCL_CACHE_DIR)?" : ""));
    }
    return program;
}

}  // namespace

cl::Program build_program(DeviceState& state, const std::string& text, const std::string& options)
{
    std::promise<cl::Program> promise;
    std::shared_future<cl::Program> program;
    {
        const std::lock_guard lock(state.guard);
        const auto [entry, is_new] = state.programs.try_emplace(options + "\n" + text);
        if (!is_new) program = entry->second;  // built, or being built by another thread
        else entry->second = promise.get_future().share();
    }
    if (program.valid()) return program.get();
    try {
        promise.set_value(compiled(state, text, options));
    } catch (...) {
        promise.set_exception(std::current_exception());
        throw;
    }
    const std::lock_guard lock(state.guard);
    return state.programs.at(options + "\n" + text).get();
}

cl::Buffer& GrowingBuffer::reserve(DeviceState& state, std::size_t bytes)
{
    bytes = std::max<std::size_t>(bytes, 64);
    if (bytes > size_) {
        release();  // never both at once
        on_device(state, "allocating device memory", [&] { buffer_ = cl::Buffer(state.context, flags_, bytes); });
        size_ = bytes;
    }
    return buffer_;
}

cl::Buffer& GrowingBuffer::upload(DeviceState& state, std::span<const std::byte> bytes)
{
    reserve(state, bytes.size());
    if (!bytes.empty())
        on_device(state, "copying to the device", [&] { state.queue.enqueueWriteBuffer(buffer_, CL_TRUE, 0, bytes.size(), bytes.data()); });
    return buffer_;
}

}  // namespace tyndall
