/// Installed into a folder, Tyndall is found by CMake and by pkg-config, and needs neither its sources nor its build folder.
#include <gmock/gmock.h>

#include <cstdlib>

#include "../../support/child_process.hpp"
#include "../../support/temporary_folder.hpp"

using namespace tyndall::test;
namespace fs = std::filesystem;

namespace {

class LibraryInstall : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder = new TemporaryFolder;
        const ProcessResult ran = run_process({CMAKE_PROGRAM, "--install", TYNDALL_BINARY_DIR, "--prefix", prefix().string()});
        ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    }
    static void TearDownTestSuite() { delete folder; }

    static fs::path prefix() { return folder->path() / "prefix"; }
    static fs::path library_folder() { return prefix() / LIBRARY_FOLDER; }
    static fs::path examples() { return prefix() / "share/doc/tyndall/examples"; }
    /// Fails the test with everything that was said.
    static void succeeds(const std::vector<std::string>& arguments, const ProcessSetup& setup = {})
    {
        const ProcessResult ran = run_process(arguments, setup);
        ASSERT_EQ(ran.exit_code, 0) << arguments[0] << ":\n" << ran.out << ran.err;
    }

    static inline TemporaryFolder* folder = nullptr;
};

TEST_F(LibraryInstall, ExamplesBuildAndRunWithFindPackage)
{
    const fs::path build = folder->path() / "build";
    succeeds({CMAKE_PROGRAM, "-S", examples().string(), "-B", build.string(), "-DCMAKE_PREFIX_PATH=" + prefix().string(), std::string("-DCMAKE_CXX_COMPILER=") + COMPILER});
    succeeds({CMAKE_PROGRAM, "--build", build.string()});
    succeeds({(build / "box_of_fog").string(), "picture.exr"}, {.folder = folder->path()});
    EXPECT_GT(fs::file_size(folder->path() / "picture.exr"), 1000u);
    EXPECT_TRUE(fs::exists(folder->path() / "picture.png"));
    succeeds({(build / "photons").string(), "photons.pfm", "1", "1"}, {.folder = folder->path()});
    EXPECT_GT(fs::file_size(folder->path() / "photons.pfm"), 12000u);
}

TEST_F(LibraryInstall, AnExampleBuildsWithPkgConfig)
{
    const ProcessSetup setup{.folder = folder->path(), .environment = {{"PKG_CONFIG_PATH", (library_folder() / "pkgconfig").string()}, {"LD_LIBRARY_PATH", library_folder().string()}}};
    const std::string command = std::string(COMPILER) + " -std=c++20 " + (examples() / "box_of_fog.cpp").string() + " -o with_pkg_config $(pkg-config --cflags --libs tyndall) && pkg-config --modversion tyndall";
    succeeds({"/bin/sh", "-c", command}, setup);
    succeeds({(folder->path() / "with_pkg_config").string(), "other.exr"}, setup);
    EXPECT_TRUE(fs::exists(folder->path() / "other.exr"));
}

TEST_F(LibraryInstall, TheProgramRunsFromThere)
{
    succeeds({(prefix() / "bin/tyndall").string(), "render", std::string(TYNDALL_SOURCE_DIR) + "/scenes/cornell_fog/scene.xml", "--resolution", "8x8", "-p", "1", "--lights", "16", "-o", "cornell.exr"}, {.folder = folder->path()});
}

TEST_F(LibraryInstall, ManualPageAndCompletionAreThere)
{
    EXPECT_GT(fs::file_size(prefix() / "share/man/man1/tyndall.1"), 1000u);
    EXPECT_GT(fs::file_size(prefix() / "share/bash-completion/completions/tyndall"), 1000u);
}

TEST_F(LibraryInstall, AnotherMinorVersionIsNotTaken)
{
    const fs::path source = folder->path() / "newer";
    fs::create_directory(source);
    const ProcessResult ran = run_process({"/bin/sh", "-c", "printf 'cmake_minimum_required(VERSION 3.21)\\nproject(newer NONE)\\nfind_package(tyndall 0.999 REQUIRED)\\n' > '" + (source / "CMakeLists.txt").string() +
                                           "' && '" CMAKE_PROGRAM "' -S '" + source.string() + "' -B '" + (source / "build").string() + "' -DCMAKE_PREFIX_PATH='" + prefix().string() + "'"});
    EXPECT_NE(ran.exit_code, 0);
    EXPECT_THAT(ran.err, testing::HasSubstr("0.999"));
}

}  // namespace
