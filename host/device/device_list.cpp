#include "device/device_list.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "device/opencl.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

std::vector<cl::Device> all_devices()
{
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        return {};  // the loader knows no platform
    }
    std::vector<cl::Device> all;
    for (const cl::Platform& platform : platforms) try {
            std::vector<cl::Device> devices;
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            all.insert(all.end(), devices.begin(), devices.end());
        } catch (const cl::Error&) {
            continue;  // a platform without devices answers with an error
        }
    return all;
}

/// Lanes pay where the compiler does not vectorise over work-items: PoCL and unknown CPU runtimes. GPUs run one item per lane by themselves.
int lanes_by_rule(bool is_cpu, unsigned native_float_width)
{
    if (!is_cpu) return 1;
    if (native_float_width >= 16) return 16;
    return native_float_width >= 8 ? 8 : 4;
}

std::string why_not_usable(const cl::Device& device, const DeviceInfo& info)
{
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "its driver says that it is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "it cannot compile kernels";
    if (!device.getInfo<CL_DEVICE_ENDIAN_LITTLE>()) return "it is big-endian";
    if (info.max_allocation < (1u << 20)) return "it allocates less than 1 MiB at a time";
    return {};
}

/// OpenCL lets divisions be off by 2.5 ulp and roots by 3. CPUs round them correctly; GPUs do where they are asked to and can.
std::string rounding_option(const cl::Device& device, bool is_cpu)
{
    const bool can = (device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    return can && !is_cpu ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
}

DeviceInfo describe_device(const cl::Device& device, int index)
{
    DeviceInfo info;
    info.index = index;
    try {
        info.name = device.getInfo<CL_DEVICE_NAME>();
        info.platform = cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>();
        info.vendor = device.getInfo<CL_DEVICE_VENDOR>();
        info.driver = device.getInfo<CL_DRIVER_VERSION>();
        info.version = device.getInfo<CL_DEVICE_VERSION>();
        info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
        info.native_float_width = device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
        info.global_memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
        info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
        info.fp64 = device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos;
        info.native_kernels = (device.getInfo<CL_DEVICE_EXECUTION_CAPABILITIES>() & CL_EXEC_NATIVE_KERNEL) != 0;
        info.is_cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
        info.build_options = rounding_option(device, info.is_cpu);
        info.default_lanes = lanes_by_rule(info.is_cpu, info.native_float_width);
        info.why_not = why_not_usable(device, info);
    } catch (const cl::Error& error) {
        info.why_not = std::string("it does not answer: ") + opencl_error_name(error.err());
    }
    info.usable = info.why_not.empty();
    return info;
}

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool matches(const DeviceInfo& info, const std::string& request)
{
    if (!request.empty() && std::all_of(request.begin(), request.end(), [](unsigned char c) { return std::isdigit(c); }))
        return std::to_string(info.index) == request;
    const auto holds = [](const std::string& text, const std::string& part) { return lower(text).find(lower(part)) != std::string::npos; };
    const std::size_t colon = request.find(':');
    if (colon == std::string::npos) return holds(info.name, request);
    return holds(info.platform, request.substr(0, colon)) && holds(info.name, request.substr(colon + 1));
}

std::string environment()
{
    std::string text;
    for (const char* variable : {"OCL_ICD_VENDORS", "OCL_ICD_FILENAMES", "POCL_DEVICES", "RUSTICL_ENABLE"})
        if (const char* value = std::getenv(variable)) text += std::string(" ") + variable + "=" + value;
    return text.empty() ? "" : "; set in the environment:" + text;
}

[[noreturn]] void refuse(const std::string& request, const std::vector<DeviceInfo>& devices)
{
    if (devices.empty())
        throw NoDeviceError("no OpenCL device: the loader found no platform with a device" + environment() +
                            "; install one, for a CPU: apt-get install pocl-opencl-icd");
    std::string text = request.empty() ? "no usable OpenCL device" : "no usable OpenCL device matches \"" + request + "\"";
    for (const DeviceInfo& d : devices)
        text += "\n  " + std::to_string(d.index) + "  " + d.platform + ": " + d.name + (d.usable ? "" : " (" + d.why_not + ")");
    throw NoDeviceError(text + environment());
}

}  // namespace

std::vector<DeviceInfo> list_devices()
{
    std::vector<DeviceInfo> list;
    for (const cl::Device& device : all_devices()) list.push_back(describe_device(device, static_cast<int>(list.size())));
    return list;
}

DeviceInfo choose_device(const std::string& request)
{
    const std::vector<DeviceInfo> devices = list_devices();
    const DeviceInfo* chosen = nullptr;
    for (const DeviceInfo& d : devices)
        if (d.usable && matches(d, request) && (!chosen || (chosen->is_cpu && !d.is_cpu))) chosen = &d;
    if (!chosen) refuse(request, devices);
    return *chosen;
}

std::vector<DeviceInfo> choose_devices(const std::string& request)
{
    std::vector<DeviceInfo> chosen;
    if (request == "all") {
        for (DeviceInfo& d : list_devices())
            if (d.usable) chosen.push_back(std::move(d));
        if (chosen.empty()) refuse("", list_devices());
        return chosen;
    }
    for (std::size_t start = 0, comma = 0; comma != std::string::npos; start = comma + 1) {
        comma = request.find(',', start);
        chosen.push_back(choose_device(request.substr(start, comma == std::string::npos ? comma : comma - start)));
    }
    return chosen;
}

cl::Device device_at(int index)
{
    const std::vector<cl::Device> devices = all_devices();
    if (index < 0 || index >= static_cast<int>(devices.size())) throw NoDeviceError("OpenCL device " + std::to_string(index) + " is gone; see `tyndall devices`");
    return devices[static_cast<std::size_t>(index)];
}

DeviceInfo info_of(const cl::Device& wanted)
{
    const std::vector<cl::Device> devices = all_devices();
    const auto found = std::find_if(devices.begin(), devices.end(), [&](const cl::Device& d) { return d() == wanted(); });
    if (found == devices.end()) throw NoDeviceError("the caller's OpenCL device is none that the loader lists; a sub-device cannot be used");
    DeviceInfo info = describe_device(*found, static_cast<int>(found - devices.begin()));
    if (!info.usable) throw NoDeviceError(info.platform + ": " + info.name + ": cannot be used: " + info.why_not);
    return info;
}

std::string opencl_error_name(int code)
{
    static const std::pair<int, const char*> names[] = {
        {-1, "CL_DEVICE_NOT_FOUND"}, {-2, "CL_DEVICE_NOT_AVAILABLE"}, {-3, "CL_COMPILER_NOT_AVAILABLE"}, {-4, "CL_MEM_OBJECT_ALLOCATION_FAILURE"},
        {-5, "CL_OUT_OF_RESOURCES"}, {-6, "CL_OUT_OF_HOST_MEMORY"}, {-11, "CL_BUILD_PROGRAM_FAILURE"}, {-12, "CL_MAP_FAILURE"},
        {-14, "CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST"}, {-30, "CL_INVALID_VALUE"}, {-36, "CL_INVALID_COMMAND_QUEUE"}, {-38, "CL_INVALID_MEM_OBJECT"},
        {-45, "CL_INVALID_PROGRAM_EXECUTABLE"}, {-46, "CL_INVALID_KERNEL_NAME"}, {-48, "CL_INVALID_KERNEL"}, {-52, "CL_INVALID_KERNEL_ARGS"},
        {-54, "CL_INVALID_WORK_GROUP_SIZE"}, {-61, "CL_INVALID_BUFFER_SIZE"}, {-1001, "CL_PLATFORM_NOT_FOUND_KHR"}};
    for (const auto& [value, text] : names)
        if (value == code) return std::string(text) + " (" + std::to_string(code) + ")";
    return "OpenCL error " + std::to_string(code);
}

}  // namespace tyndall
