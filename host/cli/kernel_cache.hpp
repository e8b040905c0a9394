#pragma once
/// PoCL keeps the kernels that it builds in a folder. Where that cannot be written it has no device or builds nothing, and where the disk is full it ends the process.
#include <cstdint>
#include <filesystem>
#include <string>

namespace tyndall {

/// The folder that PoCL would use: POCL_CACHE_DIR, or pocl/kcache in XDG_CACHE_HOME, in .cache of HOME, or in /tmp.
std::filesystem::path pocl_cache_folder();

/// Why kernels could not be kept there, as the end of a sentence; empty if they can. The folder need not exist yet; nothing is written. `room`: bytes that must be free.
std::string why_no_kernel_cache(const std::filesystem::path& folder, std::uintmax_t room);

/// Made before the first call of OpenCL: where the folder is of no use, PoCL is given a temporary one, and a warning says so. At the end that one is removed.
class KernelCache {
public:
    KernelCache();
    ~KernelCache();
    KernelCache(const KernelCache&) = delete;
    KernelCache& operator=(const KernelCache&) = delete;

private:
    std::filesystem::path temporary_;
};

}  // namespace tyndall
