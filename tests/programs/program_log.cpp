/// Stands in front of the OpenCL loader (LD_PRELOAD) and notes every program that a process builds: one line each in PROGRAM_LOG, "hash kernel", where the hash is of text and options.
/// Several processes may append at a time: a line is written at once. What cannot be noted is not: the tests go on.
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

/// The loader behind this library, also where a program opened it for itself alone (Python does, by libtyndall).
template <typename Function>
Function* in_loader(const char* name)
{
    if (void* next = dlsym(RTLD_NEXT, name)) return reinterpret_cast<Function*>(next);
    static void* const loader = dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
    return loader ? reinterpret_cast<Function*>(dlsym(loader, name)) : nullptr;
}

/// FNV-1a, 64 bits: among a thousand programs two are alike with a chance of 3e-14.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325u)
{
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

std::string source_of(cl_program program)
{
    const auto ask = in_loader<decltype(clGetProgramInfo)>("clGetProgramInfo");
    std::size_t bytes = 0;
    if (!ask || ask(program, CL_PROGRAM_SOURCE, 0, nullptr, &bytes) != CL_SUCCESS) return {};
    std::string text(bytes, '\0');
    if (bytes > 0) ask(program, CL_PROGRAM_SOURCE, bytes, text.data(), nullptr);
    return text;
}

/// The name of the last kernel in a text.
std::string kernel_in(const std::string& source)
{
    constexpr std::string_view mark = "kernel void ";
    const std::size_t at = source.rfind(mark);
    return at == std::string::npos ? "none" : source.substr(at + mark.size(), source.find('(', at) - at - mark.size());
}

void note(cl_program program, const char* options)
{
    const std::string source = source_of(program);
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(hash_of(options ? options : "", hash_of(source))));
    const std::string line = std::string(hash) + " " + kernel_in(source) + "\n";
    const int log = open(PROGRAM_LOG, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (log < 0) return;
    [[maybe_unused]] const ssize_t written = write(log, line.data(), line.size());
    close(log);
}

}  // namespace

extern "C" cl_int clBuildProgram(cl_program program, cl_uint count, const cl_device_id* devices, const char* options, void(CL_CALLBACK* done)(cl_program, void*), void* data)
{
    const auto build = in_loader<decltype(clBuildProgram)>("clBuildProgram");
    if (!build) return CL_OUT_OF_HOST_MEMORY;
    note(program, options);
    return build(program, count, devices, options, done, data);
}
