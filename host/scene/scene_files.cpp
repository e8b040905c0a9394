#include "scene/scene_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace tyndall {

namespace fs = std::filesystem;

namespace {

struct Descriptor {
    int fd;
    ~Descriptor()
    {
        if (fd >= 0) ::close(fd);
    }
};

std::string reason(int code) { return std::error_code(code, std::generic_category()).message(); }

}  // namespace

std::string read_regular_file(const fs::path& path, const SourceLocation& where, std::uintmax_t limit)
{
    const std::string name = in_quotes(path.string());
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) refuse(where, fmt::format("cannot read {}: {}", name, reason(errno)));
    if (!S_ISREG(status.st_mode)) refuse(where, name + " is not a regular file; name a file");
    // Non-blocking, in case the name became a FIFO since it was looked at.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
    if (file.fd < 0) refuse(where, fmt::format("cannot open {}: {}", name, reason(errno)));
    if (::fstat(file.fd, &status) != 0 || !S_ISREG(status.st_mode)) refuse(where, name + " is not a regular file; name a file");
    if (static_cast<std::uintmax_t>(status.st_size) > limit)
        refuse(where, fmt::format("{} has {} bytes; files of this kind are read up to {} bytes", name, status.st_size, limit));
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::read(file.fd, bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse(where, fmt::format("cannot read {}: {}", name, reason(errno)));
        if (count == 0) refuse(where, name + " became shorter while it was read; try again");
        filled += static_cast<std::size_t>(count);
    }
    return bytes;
}

SceneFiles::SceneFiles(const fs::path& folder, bool allow_outside) : allow_outside_(allow_outside)
{
    std::error_code fault;
    folder_ = fs::canonical(folder.empty() ? fs::path(".") : folder, fault);
    if (fault) folder_ = fs::path(folder).lexically_normal();  // a scene from text may name no files: said when it does
}

bool SceneFiles::inside(const fs::path& canonical) const
{
    const auto [own, other] = std::mismatch(folder_.begin(), folder_.end(), canonical.begin(), canonical.end());
    return own == folder_.end();
}

fs::path SceneFiles::find(const std::string& name, const SourceLocation& where) const
{
    if (name.empty()) refuse(where, "the file name is empty");
    if (name.find('\0') != std::string::npos) refuse(where, "the file name holds a zero byte");
    std::vector<fs::path> folders(search_folders_.rbegin(), search_folders_.rend());
    folders.push_back(folder_);
    bool outside = false;
    for (const fs::path& folder : folders) {
        std::error_code fault;
        fs::path found = fs::canonical(folder / name, fault);  // an absolute name replaces the folder; symbolic links are followed
        if (fault) continue;
        if (allow_outside_ || inside(found)) return found;
        outside = true;
    }
    // A name that leaves the folder gets one answer, whether or not something is there: a scene must not find out.
    const fs::path plain = (folder_ / name).lexically_normal();
    if (outside || (!allow_outside_ && !inside(plain)))
        refuse(where, in_quotes(name) + " leads outside the scene's folder; move the file there, or allow it with --allow-outside");
    refuse(where, fmt::format("cannot find {} in {}", in_quotes(name), in_quotes(folder_.string())));
}

void SceneFiles::add_search_folder(const std::string& name, const SourceLocation& where)
{
    const fs::path folder = find(name, where);
    if (!fs::is_directory(folder)) refuse(where, in_quotes(name) + " is not a folder");
    search_folders_.push_back(folder);
}

SceneFiles::Content SceneFiles::read(const std::string& name, const SourceLocation& where, std::uintmax_t limit)
{
    Content content{.path = find(name, where)};
    content.bytes = read_regular_file(content.path, where, limit);
    hash_.add(content.bytes);
    return content;
}

}  // namespace tyndall
