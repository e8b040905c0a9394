#include "faulty_opencl.hpp"

#define CL_TARGET_OPENCL_VERSION 300
#include <CL/cl.h>
#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <sstream>

namespace tyndall::test {

void OpenClFaults::reset()
{
    calls = 0, fail_at = -1, failures = 1, error = -5;
    largest_buffer = memory = largest_group = largest_asked = 0;
    no_profiling = no_devices = no_platforms = queries = late = hang = say = false;
    poison = -1, reads = 0;
    failed.clear();
}

namespace {

void read_environment(OpenClFaults& faults)
{
    const char* text = std::getenv("TYNDALL_FAULTY_OPENCL");
    std::istringstream words(text ? text : "");
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const long value = equals == std::string::npos ? 1 : std::atol(word.c_str() + equals + 1);
        const auto size = static_cast<std::size_t>(value);
        if (name == "fail_at") faults.fail_at = value;
        if (name == "failures") faults.failures = value;
        if (name == "error") faults.error = static_cast<int>(value);
        if (name == "largest_buffer") faults.largest_buffer = size;
        if (name == "memory") faults.memory = size;
        if (name == "largest_group") faults.largest_group = size;
        if (name == "no_profiling") faults.no_profiling = value != 0;
        if (name == "no_devices") faults.no_devices = value != 0;
        if (name == "no_platforms") faults.no_platforms = value != 0;
        if (name == "queries") faults.queries = value != 0;
        if (name == "late") faults.late = value != 0;
        if (name == "hang") faults.hang = value != 0;
        if (name == "poison") faults.poison = value;
        if (name == "say") faults.say = value != 0;
    }
}

std::mutex guard;                          ///< of what follows and of `failed`
std::map<cl_mem, std::size_t> allocated;

}  // namespace

OpenClFaults& opencl_faults()
{
    static OpenClFaults faults;
    static const bool read = (read_environment(faults), true);
    static_cast<void>(read);
    return faults;
}

namespace {

/// CL_SUCCESS, or the code that this call is to fail with.
cl_int verdict(const char* function)
{
    OpenClFaults& faults = opencl_faults();
    const long call = faults.calls++, first = faults.fail_at;
    if (first < 0 || call < first || call - first >= faults.failures) return CL_SUCCESS;
    const std::lock_guard lock(guard);
    faults.failed = function;
    if (faults.say) std::fprintf(stderr, "faulty OpenCL: %s\n", function);
    while (faults.hang) ::pause();
    return faults.error;
}

/// The same for a call that only asks.
cl_int verdict_on_query(const char* function) { return opencl_faults().queries ? verdict(function) : CL_SUCCESS; }

/// What a call returns that has done its work all the same.
cl_int after_all(cl_int code, cl_int real) { return code != CL_SUCCESS ? code : real; }

cl_int room_for(std::size_t bytes)
{
    OpenClFaults& faults = opencl_faults();
    if (bytes > faults.largest_asked) faults.largest_asked = bytes;
    if (faults.largest_buffer && bytes > faults.largest_buffer) return CL_INVALID_BUFFER_SIZE;
    const std::lock_guard lock(guard);
    std::size_t sum = bytes;
    for (const auto& [buffer, size] : allocated) sum += size;
    return faults.memory && sum > faults.memory ? CL_MEM_OBJECT_ALLOCATION_FAILURE : CL_SUCCESS;
}

template <typename Handle>
Handle refused(cl_int code, cl_int* out)
{
    if (out) *out = code;
    return nullptr;
}

}  // namespace
}  // namespace tyndall::test

using tyndall::test::after_all;
using tyndall::test::opencl_faults;
using tyndall::test::verdict;
using tyndall::test::verdict_on_query;

#define REAL(name) (reinterpret_cast<decltype(&name)>(dlsym(RTLD_NEXT, #name)))
/// A function that returns its error code.
#define MAY_FAIL(name, parameters, arguments)                         \
    cl_int name parameters                                            \
    {                                                                 \
        const cl_int code = verdict(#name);                           \
        if (code != CL_SUCCESS && !opencl_faults().late) return code; \
        return after_all(code, REAL(name) arguments);                 \
    }
/// One that only asks.
#define MAY_NOT_TELL(name, parameters, arguments)                                         \
    cl_int name parameters                                                                \
    {                                                                                     \
        if (const cl_int code = verdict_on_query(#name); code != CL_SUCCESS) return code; \
        return REAL(name) arguments;                                                      \
    }
/// One that returns a handle and stores its error code in `out`.
#define MAY_GIVE_NOTHING(type, name, parameters, arguments)                                                         \
    type name parameters                                                                                            \
    {                                                                                                               \
        if (const cl_int code = verdict(#name); code != CL_SUCCESS) return tyndall::test::refused<type>(code, out); \
        return REAL(name) arguments;                                                                                \
    }

extern "C" {

cl_int clGetPlatformIDs(cl_uint entries, cl_platform_id* platforms, cl_uint* count)
{
    if (opencl_faults().no_platforms) return -1001;  // CL_PLATFORM_NOT_FOUND_KHR
    if (const cl_int code = verdict_on_query("clGetPlatformIDs"); code != CL_SUCCESS) return code;
    return REAL(clGetPlatformIDs)(entries, platforms, count);
}
cl_int clGetDeviceIDs(cl_platform_id platform, cl_device_type type, cl_uint entries, cl_device_id* devices, cl_uint* count)
{
    if (opencl_faults().no_devices) return CL_DEVICE_NOT_FOUND;
    if (const cl_int code = verdict_on_query("clGetDeviceIDs"); code != CL_SUCCESS) return code;
    return REAL(clGetDeviceIDs)(platform, type, entries, devices, count);
}
cl_int clGetKernelWorkGroupInfo(cl_kernel kernel, cl_device_id device, cl_kernel_work_group_info what, size_t size, void* value, size_t* needed)
{
    if (const cl_int fault = verdict_on_query("clGetKernelWorkGroupInfo"); fault != CL_SUCCESS) return fault;
    const cl_int code = REAL(clGetKernelWorkGroupInfo)(kernel, device, what, size, value, needed);
    if (code == CL_SUCCESS && what == CL_KERNEL_WORK_GROUP_SIZE && value && opencl_faults().largest_group) *static_cast<size_t*>(value) = opencl_faults().largest_group;
    return code;
}
cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions, const size_t* offset, const size_t* global, const size_t* local, cl_uint waits,
                              const cl_event* wait_list, cl_event* event)
{
    const cl_int code = verdict("clEnqueueNDRangeKernel");
    if (code != CL_SUCCESS && !opencl_faults().late) return code;
    if (opencl_faults().largest_group && local && *local > opencl_faults().largest_group) return CL_INVALID_WORK_GROUP_SIZE;
    return after_all(code, REAL(clEnqueueNDRangeKernel)(queue, kernel, dimensions, offset, global, local, waits, wait_list, event));
}
cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t bytes, void* host, cl_int* out)
{
    cl_int code = verdict("clCreateBuffer");
    if (code == CL_SUCCESS) code = tyndall::test::room_for(bytes);
    if (code != CL_SUCCESS) return tyndall::test::refused<cl_mem>(code, out);
    const cl_mem buffer = REAL(clCreateBuffer)(context, flags, bytes, host, out);
    const std::lock_guard lock(tyndall::test::guard);
    if (buffer) tyndall::test::allocated[buffer] = bytes;
    return buffer;
}
cl_int clReleaseMemObject(cl_mem buffer)
{
    {
        const std::lock_guard lock(tyndall::test::guard);
        tyndall::test::allocated.erase(buffer);
    }
    return REAL(clReleaseMemObject)(buffer);
}
cl_command_queue clCreateCommandQueueWithProperties(cl_context context, cl_device_id device, const cl_queue_properties* properties, cl_int* out)
{
    cl_int code = verdict("clCreateCommandQueueWithProperties");
    for (const cl_queue_properties* p = properties; p && *p && code == CL_SUCCESS; p += 2)
        if (p[0] == CL_QUEUE_PROPERTIES && (p[1] & CL_QUEUE_PROFILING_ENABLE) && opencl_faults().no_profiling) code = CL_INVALID_QUEUE_PROPERTIES;
    if (code != CL_SUCCESS) return tyndall::test::refused<cl_command_queue>(code, out);
    return REAL(clCreateCommandQueueWithProperties)(context, device, properties, out);
}
cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t bytes, void* to, cl_uint waits, const cl_event* wait_list, cl_event* event)
{
    const cl_int code = verdict("clEnqueueReadBuffer");
    if (code != CL_SUCCESS && !opencl_faults().late) return code;
    const cl_int real = REAL(clEnqueueReadBuffer)(queue, buffer, blocking, offset, bytes, to, waits, wait_list, event);
    if (opencl_faults().reads++ == opencl_faults().poison && real == CL_SUCCESS)
        for (size_t word = 0; word + sizeof(cl_uint) <= bytes; word += sizeof(cl_uint)) std::memcpy(static_cast<char*>(to) + word, "\0\0\xc0\x7f", sizeof(cl_uint));
    return after_all(code, real);
}

MAY_GIVE_NOTHING(cl_context, clCreateContext,
                 (const cl_context_properties* properties, cl_uint count, const cl_device_id* devices, void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*), void* user, cl_int* out),
                 (properties, count, devices, notify, user, out))
MAY_GIVE_NOTHING(cl_program, clCreateProgramWithSource, (cl_context context, cl_uint count, const char** texts, const size_t* lengths, cl_int* out), (context, count, texts, lengths, out))
MAY_GIVE_NOTHING(cl_kernel, clCreateKernel, (cl_program program, const char* name, cl_int* out), (program, name, out))
MAY_GIVE_NOTHING(void*, clEnqueueMapBuffer,
                 (cl_command_queue queue, cl_mem buffer, cl_bool blocking, cl_map_flags flags, size_t offset, size_t bytes, cl_uint waits, const cl_event* wait_list, cl_event* event, cl_int* out),
                 (queue, buffer, blocking, flags, offset, bytes, waits, wait_list, event, out))
MAY_FAIL(clBuildProgram,
         (cl_program program, cl_uint count, const cl_device_id* devices, const char* options, void(CL_CALLBACK* notify)(cl_program, void*), void* user),
         (program, count, devices, options, notify, user))
MAY_FAIL(clSetKernelArg, (cl_kernel kernel, cl_uint index, size_t bytes, const void* value), (kernel, index, bytes, value))
MAY_FAIL(clEnqueueWriteBuffer,
         (cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t bytes, const void* from, cl_uint waits, const cl_event* wait_list, cl_event* event),
         (queue, buffer, blocking, offset, bytes, from, waits, wait_list, event))
MAY_FAIL(clEnqueueFillBuffer,
         (cl_command_queue queue, cl_mem buffer, const void* pattern, size_t size, size_t offset, size_t bytes, cl_uint waits, const cl_event* wait_list, cl_event* event),
         (queue, buffer, pattern, size, offset, bytes, waits, wait_list, event))
MAY_FAIL(clEnqueueUnmapMemObject, (cl_command_queue queue, cl_mem buffer, void* mapped, cl_uint waits, const cl_event* wait_list, cl_event* event),
         (queue, buffer, mapped, waits, wait_list, event))
MAY_FAIL(clEnqueueMarkerWithWaitList, (cl_command_queue queue, cl_uint waits, const cl_event* wait_list, cl_event* event), (queue, waits, wait_list, event))
MAY_FAIL(clEnqueueNativeKernel,
         (cl_command_queue queue, void(CL_CALLBACK* work)(void*), void* arguments, size_t bytes, cl_uint buffers, const cl_mem* list, const void** places, cl_uint waits,
          const cl_event* wait_list, cl_event* event),
         (queue, work, arguments, bytes, buffers, list, places, waits, wait_list, event))
MAY_FAIL(clWaitForEvents, (cl_uint count, const cl_event* events), (count, events))
MAY_FAIL(clGetEventProfilingInfo, (cl_event event, cl_profiling_info what, size_t size, void* value, size_t* needed), (event, what, size, value, needed))
MAY_FAIL(clFlush, (cl_command_queue queue), (queue))
MAY_FAIL(clFinish, (cl_command_queue queue), (queue))

MAY_NOT_TELL(clGetPlatformInfo, (cl_platform_id platform, cl_platform_info what, size_t size, void* value, size_t* needed), (platform, what, size, value, needed))
MAY_NOT_TELL(clGetDeviceInfo, (cl_device_id device, cl_device_info what, size_t size, void* value, size_t* needed), (device, what, size, value, needed))
MAY_NOT_TELL(clGetContextInfo, (cl_context context, cl_context_info what, size_t size, void* value, size_t* needed), (context, what, size, value, needed))
MAY_NOT_TELL(clGetCommandQueueInfo, (cl_command_queue queue, cl_command_queue_info what, size_t size, void* value, size_t* needed), (queue, what, size, value, needed))
MAY_NOT_TELL(clGetProgramInfo, (cl_program program, cl_program_info what, size_t size, void* value, size_t* needed), (program, what, size, value, needed))
MAY_NOT_TELL(clGetProgramBuildInfo, (cl_program program, cl_device_id device, cl_program_build_info what, size_t size, void* value, size_t* needed),
             (program, device, what, size, value, needed))
MAY_NOT_TELL(clGetEventInfo, (cl_event event, cl_event_info what, size_t size, void* value, size_t* needed), (event, what, size, value, needed))

}  // extern "C"
