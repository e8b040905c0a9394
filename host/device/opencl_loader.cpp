#include "device/opencl_loader.hpp"

#include <fmt/format.h>

#include <array>

#include "device/opencl.hpp"

namespace tyndall {
namespace {

// Of ocl-icd and of Khronos' loader; only newer headers than Debian's declare it.
using LoaderInfo = cl_int(CL_API_CALL*)(cl_uint what, std::size_t size, void* value, std::size_t* needed);
enum : cl_uint { opencl_version = 1, loader_version = 2, loader_name = 3, loader_vendor = 4 };

/// "" for what the loader does not know.
std::string ask(LoaderInfo info, cl_uint what)
{
    std::array<char, 256> text{};
    if (info(what, text.size() - 1, text.data(), nullptr) != CL_SUCCESS) return "";  // the last byte stays zero
    return text.data();
}

}  // namespace

std::string opencl_loader()
{
    const auto info = reinterpret_cast<LoaderInfo>(clGetExtensionFunctionAddress("clGetICDLoaderInfoOCLICD"));
    const std::string version = info == nullptr ? "" : ask(info, loader_version);
    if (version.empty()) return "";
    return fmt::format("{} {} ({}), {}", ask(info, loader_name), version, ask(info, loader_vendor), ask(info, opencl_version));
}

}  // namespace tyndall
