#include "film/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using test::file_bytes;

std::size_t files_in(const std::filesystem::path& folder)
{
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// The message of the IoError that the action throws; empty if it throws none.
template <class Action>
std::string io_error(Action&& action)
{
    try {
        action();
    } catch (const IoError& error) {
        return error.what();
    }
    return {};
}

TEST(AtomicFile, AppearsWholeAtCommitOnly)
{
    test::TemporaryFolder folder;
    {
        AtomicFile file(folder / "a.txt");
        file.write("hello", 5);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
        file.commit();
    }
    EXPECT_EQ(file_bytes(folder / "a.txt"), "hello");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit)
{
    test::TemporaryFolder folder;
    {
        AtomicFile(folder / "a.txt").write("hello", 5);
    }
    EXPECT_EQ(files_in(folder.path()), 0u);
}

TEST(AtomicFile, ReplacesTheOldFileAndSeeks)
{
    test::TemporaryFolder folder;
    write_atomically(folder / "a", "a longer old text");
    AtomicFile file(folder / "a");
    file.write("....tail", 8);
    file.seek(0);
    file.write("head", 4);
    EXPECT_EQ(file.position(), 4u);
    file.commit();
    EXPECT_EQ(file_bytes(folder / "a"), "headtail");
}

TEST(AtomicFile, FollowsASymbolicLink)
{
    test::TemporaryFolder folder;
    write_atomically(folder / "real", "old");
    std::filesystem::create_symlink("real", folder / "link");
    write_atomically(folder / "link", "new");
    EXPECT_EQ(file_bytes(folder / "real"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
}

TEST(AtomicFile, RefusesAMissingFolderWithAdvice)
{
    test::TemporaryFolder folder;
    const auto message = io_error([&] { check_writable(folder / "no" / "a.exr"); });
    EXPECT_NE(message.find("no/a.exr"), std::string::npos) << message;
    EXPECT_NE(message.find("create the folder first"), std::string::npos) << message;
}

TEST(AtomicFile, RefusesFoldersDevicesAndPipes)
{
    test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const std::filesystem::path& target : {folder.path(), std::filesystem::path("/dev/full"), folder / "pipe"})
        EXPECT_NE(io_error([&] { check_writable(target); }).find("not a regular file"), std::string::npos) << target;
}

TEST(AtomicFile, RefusesAFolderThatCannotBeWrittenTo)
{
    // Root may write anywhere but into the kernel's own file systems.
    EXPECT_NE(io_error([] { check_writable("/proc/tyndall.exr"); }), "");
    if (::geteuid() == 0) return;
    test::TemporaryFolder folder;
    ::chmod(folder.path().c_str(), 0500);
    EXPECT_NE(io_error([&] { check_writable(folder / "a.exr"); }).find("may write to"), std::string::npos);
    ::chmod(folder.path().c_str(), 0700);
}

/// In a child process, because a file size limit cannot be taken back: exit 0 if the promise holds.
[[noreturn]] void write_beyond_the_limit(const std::filesystem::path& target)
{
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto message = io_error([&] { write_atomically(target, std::string(100000, 'x')); });
    ::_exit(message.find("ulimit -f") != std::string::npos ? 0 : 1);
}

TEST(AtomicFile, KeepsTheOldFileWhenTheNewOneDoesNotFit)
{
    test::TemporaryFolder folder;
    write_atomically(folder / "a", "old");
    const pid_t child = ::fork();
    if (child == 0) write_beyond_the_limit(folder / "a");
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(file_bytes(folder / "a"), "old");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(AtomicFile, RemembersAFailureThatALibrarySwallowed)
{
    test::TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{10, 10};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        AtomicFile file(folder / "a");
        const bool first = !io_error([&] { file.write("more than ten bytes", 19); }).empty();
        const bool second = !io_error([&] { file.commit(); }).empty();
        ::_exit(first && second && file.failed() ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

TEST(AtomicFile, RemovesUnfinishedFilesForAnExitAtOnce)
{
    test::TemporaryFolder folder;
    AtomicFile file(folder / "a");
    AtomicFile done(folder / "b");
    done.commit();
    EXPECT_EQ(files_in(folder.path()), 2u);
    AtomicFile::remove_unfinished();
    EXPECT_EQ(files_in(folder.path()), 1u);
    EXPECT_TRUE(std::filesystem::exists(folder / "b"));
}

}  // namespace
}  // namespace tyndall
