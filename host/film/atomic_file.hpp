#pragma once
/// A file that appears under its name whole or not at all: written beside its target under another name, flushed to the disk, then renamed.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tyndall {

class AtomicFile {
public:
    /// Opens a temporary file in the folder of `target`. A symbolic link is followed. Throws IoError if the folder is missing or not
    /// writable, or if `target` exists and is not a regular file (renaming onto a device or a folder would destroy or miss it).
    explicit AtomicFile(const std::filesystem::path& target);
    /// Removes the temporary file unless it was committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Appends at the current position. A failure is remembered and thrown again by `commit`, for callers whose library swallows
    /// exceptions.
    void write(const void* data, std::size_t size);
    void seek(std::uint64_t position);
    std::uint64_t position() const { return position_; }
    /// Flushes to the disk and renames onto the target. Throws IoError (TemporaryError where another try may help); the old file is kept then.
    void commit();
    bool failed() const { return !failure_.empty(); }
    /// What went wrong first, as a sentence; empty if nothing did.
    const std::string& failure() const { return failure_; }

    /// Removes the temporary files of this process that are not committed. Safe inside a signal handler, for an exit at once.
    static void remove_unfinished() noexcept;

private:
    [[noreturn]] void fail(const char* action, int error_number);
    [[noreturn]] void throw_failure() const;
    void open_temporary();

    std::filesystem::path target_, temporary_;
    int descriptor_ = -1, slot_ = -1;
    std::uint64_t position_ = 0;
    std::string failure_;
    bool temporary_failure_ = false;
};

/// Throws IoError, as writing would, if a file of that name cannot be created or replaced. For asking before hours of work.
void check_writable(const std::filesystem::path& target);

/// Writes the bytes atomically. Throws IoError.
void write_atomically(const std::filesystem::path& target, std::string_view bytes);

}  // namespace tyndall
