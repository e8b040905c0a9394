#pragma once
/// The only door through which a scene reaches the file system: finds what a scene names, refuses what it must not read, and folds every
/// byte that was read into the scene's hash.
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_hash.hpp"
#include "scene/text.hpp"

namespace tyndall {

class SceneFiles {
public:
    /// `folder`: where relative names start and what names must not leave, unless `allow_outside`.
    SceneFiles(const std::filesystem::path& folder, bool allow_outside);

    /// `<path value>`: looked into before the scene's own folder. Must be a folder (inside the scene's, unless allowed).
    void add_search_folder(const std::string& name, const SourceLocation& where);

    struct Content {
        std::filesystem::path path;  ///< canonical
        std::string bytes;
    };
    /// Whole content of a regular file of at most `limit` bytes. Throws SceneError at `where` if it is missing, outside, not a regular file
    /// or larger.
    Content read(const std::string& name, const SourceLocation& where, std::uintmax_t limit);

    /// Canonical path of the file that `name` means. Throws SceneError at `where` if it is missing or outside.
    std::filesystem::path find(const std::string& name, const SourceLocation& where) const;

    /// The hash of everything read so far; the loader adds what is not a file (text given in memory, definitions).
    SceneHash& hash() { return hash_; }

private:
    bool inside(const std::filesystem::path& canonical) const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> search_folders_;
    bool allow_outside_;
    SceneHash hash_;
};

/// Reads a regular file of at most `limit` bytes without ever blocking on a FIFO or reading a device. Throws SceneError at `where`.
std::string read_regular_file(const std::filesystem::path& path, const SourceLocation& where, std::uintmax_t limit);

}  // namespace tyndall
