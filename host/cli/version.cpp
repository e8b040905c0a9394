#include "cli/version.hpp"

#include <fmt/format.h>

#include "commit.h"     // made at build time by commit.cmake
#include "libraries.h"  // made by CMake from libraries.h.in

namespace tyndall {

std::string version() { return fmt::format("{} ({})", TYNDALL_VERSION, TYNDALL_COMMIT); }

std::string version_number() { return TYNDALL_VERSION; }

std::string version_text(const std::string& loader)
{
    const std::string opencl = loader.empty() ? "OpenCL headers " TYNDALL_OPENCL_HEADERS ", the loader does not say its version" : loader;
    return fmt::format("tyndall {}\ncompiled with {}\n{}\n{}", version(), TYNDALL_COMPILER, opencl, TYNDALL_LIBRARIES);
}

}  // namespace tyndall
