#include "cli/kernel_cache.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "cli/say.hpp"
#include "report/readable.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

/// The programs of a scene take a quarter of a MiB, with density grids a few; LLVM writes temporary files besides.
constexpr std::uintmax_t enough_room = 16u << 20;

std::string error_words() { return std::generic_category().message(errno); }

std::string variable(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// The folder itself, or the nearest above it that there is.
fs::path existing(fs::path folder)
{
    std::error_code ignored;
    folder = fs::absolute(folder, ignored).lexically_normal();
    while (!fs::exists(folder, ignored) && folder != folder.root_path()) folder = folder.parent_path();
    return folder;
}

}  // namespace

fs::path pocl_cache_folder()
{
    if (const std::string own = variable("POCL_CACHE_DIR"); !own.empty()) return own;
    if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return fs::path(cache) / "pocl/kcache";
    if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache/pocl/kcache";
    return "/tmp/pocl/kcache";
}

std::string why_no_kernel_cache(const fs::path& folder, std::uintmax_t room)
{
    const fs::path place = existing(folder);
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) return place.string() + " is not a folder";
    if (::faccessat(AT_FDCWD, place.c_str(), W_OK | X_OK, AT_EACCESS) != 0) return place.string() + ": " + error_words();
    struct statvfs state {};
    if (::statvfs(place.c_str(), &state) != 0) return place.string() + ": " + error_words();
    const std::uintmax_t free = std::uintmax_t{state.f_bavail} * state.f_frsize;
    return free >= room ? std::string() : fmt::format("{} KiB are free there, and it may take {} MiB", free >> 10, room >> 20);
}

KernelCache::KernelCache()
{
    const fs::path folder = pocl_cache_folder();
    const std::string why = why_no_kernel_cache(folder, enough_room);
    if (why.empty()) return;
    std::error_code fault;
    const fs::path elsewhere = fs::temp_directory_path(fault);
    std::string name = (elsewhere / "tyndall-kernels-XXXXXX").string();
    const std::string advice = "set POCL_CACHE_DIR to a folder with room";
    if (fault || !why_no_kernel_cache(elsewhere, enough_room).empty() || !::mkdtemp(name.data())) {
        say(stderr, "warning: PoCL cannot keep kernels in {}: {}; {}\n", terminal_safe(folder.string()), terminal_safe(why), advice);
        return;
    }
    temporary_ = name;
    ::setenv("POCL_CACHE_DIR", name.c_str(), 1);
    say(stderr, "warning: PoCL cannot keep kernels in {}: {}; they are built again for this run alone. To keep them, {}\n", terminal_safe(folder.string()), terminal_safe(why), advice);
}

KernelCache::~KernelCache()
{
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

}  // namespace tyndall
