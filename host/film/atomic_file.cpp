#include "film/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>

#include <fmt/format.h>

#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

/// Names of the temporary files in use, where a signal handler can reach them. A file beyond the last slot is only removed by its
/// destructor.
struct Slot {
    std::atomic<int> state{0};  ///< 0 free, 1 being filled, 2 holds a name
    char name[PATH_MAX];
};
std::array<Slot, 16> slots;

int claim_slot(const std::string& name)
{
    if (name.size() >= PATH_MAX) return -1;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        int free = 0;
        if (!slots[i].state.compare_exchange_strong(free, 1)) continue;
        std::memcpy(slots[i].name, name.c_str(), name.size() + 1);
        slots[i].state = 2;
        return static_cast<int>(i);
    }
    return -1;
}

void release_slot(int slot)
{
    if (slot >= 0) slots[slot].state = 0;
}

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

fs::path resolved(const fs::path& target)
{
    std::error_code ignored;
    const auto real = fs::canonical(target, ignored);
    return ignored ? target : real;
}

/// Does another try help? Network file systems fail like this while a server restarts.
bool is_temporary(int error_number)
{
    switch (error_number) {
        case EAGAIN:
        case EBUSY:
        case ENOLCK:
        case ESTALE:
        case ETIMEDOUT:
            return true;
        default:
            return false;
    }
}

const char* advice(int error_number)
{
    switch (error_number) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or choose another folder";
        case EFBIG:
            return "the file size limit (ulimit -f) is too low for it";
        case ENOENT:
            return "create the folder first";
        case EROFS:
        case EACCES:
        case EPERM:
            return "choose a folder that you may write to";
        default:
            return is_temporary(error_number) ? "try again: the file system may recover" : "choose another file name or folder";
    }
}

bool not_supported(int error_number) { return error_number == EINVAL || error_number == ENOTSUP; }

/// Makes the rename itself survive a power cut; failing to do so leaves a good file, so errors do not count.
void sync_folder(const fs::path& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

void AtomicFile::fail(const char* action, int error_number)
{
    if (failure_.empty())
        failure_ = fmt::format("{}: {}: {}; nothing was changed there: {}", target_.string(), action, std::strerror(error_number),
                               advice(error_number));
    temporary_failure_ = is_temporary(error_number);
    throw_failure();
}

void AtomicFile::throw_failure() const
{
    if (temporary_failure_) throw TemporaryError(failure_);
    throw IoError(failure_);
}

AtomicFile::AtomicFile(const fs::path& target) : target_(resolved(target))
{
    struct stat status;
    if (target_.filename().empty()) fail("cannot write a file without a name", EINVAL);
    if (::stat(target_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
        failure_ = fmt::format("{}: exists and is not a regular file; choose another name for the output", target_.string());
        throw IoError(failure_);
    }
    open_temporary();
}

void AtomicFile::open_temporary()
{
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {  // a name can be taken by another machine's process of our number
        temporary_ = folder_of(target_) / fmt::format(".tyndall-{}-{}.tmp", ::getpid(), counter++);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail("cannot create a file in its folder", errno);
    slot_ = claim_slot(temporary_.string());
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        ::unlink(temporary_.c_str());
    }
    release_slot(slot_);
}

void AtomicFile::write(const void* data, std::size_t size)
{
    if (failed()) throw_failure();
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::pwrite(descriptor_, next, size, static_cast<off_t>(position_));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail("cannot write", written < 0 ? errno : ENOSPC);
        next += written, size -= static_cast<std::size_t>(written), position_ += static_cast<std::uint64_t>(written);
    }
}

void AtomicFile::seek(std::uint64_t position) { position_ = position; }

void AtomicFile::commit()
{
    if (failed()) throw_failure();
    if (::fsync(descriptor_) != 0 && !not_supported(errno)) fail("cannot flush to the disk", errno);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0 || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
        const int error_number = errno;
        ::unlink(temporary_.c_str());
        fail("cannot rename the finished file onto it", error_number);
    }
    release_slot(slot_), slot_ = -1;
    sync_folder(folder_of(target_));
}

void AtomicFile::remove_unfinished() noexcept
{
    for (auto& slot : slots)
        if (slot.state == 2) ::unlink(slot.name);
}

void check_writable(const fs::path& target) { AtomicFile probe(target); }

void write_atomically(const fs::path& target, std::string_view bytes)
{
    AtomicFile file(target);
    file.write(bytes.data(), bytes.size());
    file.commit();
}

}  // namespace tyndall
