// A device passes its golden cases once: not at every start, but again for another driver, lane width or kernel.
#include "selftest/first_use.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "planted_kernel.hpp"
#include "support/environment_variable.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FirstUseOfADevice : public testing::Test {
protected:
    std::vector<fs::path> stamps() const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder / "tyndall")) files.push_back(entry.path());
        return files;
    }
    TemporaryFolder folder;
    EnvironmentVariable cache{"XDG_CACHE_HOME", folder.path().c_str()};
    FirstUse use{.device = choose_device(""), .lanes = 8, .families = 1};  // compiled in half a second, all of them in two
};

TEST_F(FirstUseOfADevice, ChecksWhatARenderUsesAndTheRestWhenAnotherUsesIt)
{
    const SelftestReport plain = check_on_first_use(use);
    EXPECT_EQ(check_on_first_use(use).outcome, "passed before");
    use.families = every_case_family;
    const SelftestReport all = check_on_first_use(use);
    EXPECT_EQ(all.outcome, "passed");
    EXPECT_GT(all.outputs, plain.outputs + 800) << "grids, lobes, conditionals and marginals";
}

TEST_F(FirstUseOfADevice, RunsOnceAndRemembers)
{
    const SelftestReport first = check_on_first_use(use), second = check_on_first_use(use);
    EXPECT_EQ(first.outcome, "passed");
    EXPECT_GT(first.outputs, 3000u);
    EXPECT_GT(first.seconds, 0);
    EXPECT_EQ(first.warning, "");
    EXPECT_EQ(second.outcome, "passed before");
    EXPECT_EQ(second.outputs, 0u);
    EXPECT_EQ(second.remembered_in, first.remembered_in);
    ASSERT_EQ(stamps().size(), 1u);
    EXPECT_EQ(stamps().front(), first.remembered_in);
    struct stat status;
    ASSERT_EQ(::stat((folder / "tyndall").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0700u);
}

TEST_F(FirstUseOfADevice, RunsAgainForAnotherDriverDeviceOrLaneWidth)
{
    EXPECT_EQ(check_on_first_use(use).outcome, "passed");
    FirstUse driver = use, name = use, lanes = use;
    driver.device.driver += "1", name.device.name += " II", lanes.lanes = 4;
    for (const FirstUse& other : {driver, name, lanes}) {
        EXPECT_EQ(check_on_first_use(other).outcome, "passed");
        EXPECT_EQ(check_on_first_use(other).outcome, "passed before");
    }
    EXPECT_EQ(stamps().size(), 4u);
    EXPECT_EQ(check_on_first_use(use).outcome, "passed before");
}

TEST_F(FirstUseOfADevice, StampsDependOnTheKernels)
{
    FirstUse other = use;
    other.source = planted_kernel("outputs(s.potential, s.v,", "outputs( s.potential, s.v,");
    EXPECT_NE(stamp_of(use).name, stamp_of(other).name);
    EXPECT_EQ(stamp_of(use).text, stamp_of(use).text);
}

TEST_F(FirstUseOfADevice, AStampThatSaysSomethingElseIsNotBelieved)
{
    const fs::path stamp = check_on_first_use(use).remembered_in;
    std::ofstream(stamp, std::ios::binary) << "passed, trust me\n";
    EXPECT_EQ(check_on_first_use(use).outcome, "passed");
    EXPECT_EQ(check_on_first_use(use).outcome, "passed before");
}

TEST_F(FirstUseOfADevice, AFailureNamesTheCaseAndIsNotRemembered)
{
    use.source = wrong_potentials();
    for (int i = 0; i < 2; ++i) try {
            check_on_first_use(use);
            FAIL() << "a wrong kernel passed";
        } catch (const DeviceError& error) {
            EXPECT_THAT(error.what(), HasSubstr("Row01NearlyParallelLightKeepsItsPotential"));
            EXPECT_THAT(error.what(), HasSubstr("tyndall selftest --bundle"));
            EXPECT_THAT(error.what(), HasSubstr("--no-selftest"));
        }
    EXPECT_TRUE(stamps().empty());
}

TEST_F(FirstUseOfADevice, WithoutAUsableCacheItRunsEveryTimeAndSaysSo)
{
    std::ofstream(folder / "file") << "x";
    fs::create_directories(folder / "open/tyndall");
    fs::permissions(folder / "open/tyndall", fs::perms::all);
    for (const char* name : {"file", "open"}) {
        const EnvironmentVariable elsewhere("XDG_CACHE_HOME", (folder / name).c_str());
        for (int i = 0; i < 2; ++i) {
            const SelftestReport report = check_on_first_use(use);
            EXPECT_EQ(report.outcome, "passed");
            EXPECT_EQ(report.remembered_in, "");
            EXPECT_THAT(report.warning, HasSubstr((folder / name).string()));
            EXPECT_THAT(report.warning, HasSubstr("set XDG_CACHE_HOME"));
        }
    }
}

TEST_F(FirstUseOfADevice, CacheFolderIsThatOfTheDesktopOrTheHomeFolders)
{
    EXPECT_EQ(cache_folder(), folder / "tyndall");
    const EnvironmentVariable relative("XDG_CACHE_HOME", "not/absolute"), home("HOME", "/home/somebody");
    EXPECT_EQ(cache_folder(), "/home/somebody/.cache/tyndall");
    const EnvironmentVariable none("HOME", nullptr);
    EXPECT_EQ(cache_folder(), "");
    EXPECT_THAT(check_on_first_use(use).warning, HasSubstr("HOME"));
}

}  // namespace
}  // namespace tyndall::test
