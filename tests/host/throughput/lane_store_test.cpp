// The kept lane width, in a folder of its own.
#include "throughput/lane_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "support/child_process.hpp"
#include "support/environment_variable.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LaneStore : public testing::Test {
protected:
    void write(const std::string& text) const
    {
        fs::create_directories(lane_file(device).parent_path());
        std::ofstream(lane_file(device), std::ios::binary) << text;
    }
    void expect_ignored(const std::string& text, const std::string& reason) const
    {
        write(text);
        const StoredLanes stored = stored_lanes(device);
        EXPECT_EQ(stored.lanes, 0) << text;
        EXPECT_THAT(stored.warning, testing::AllOf(HasSubstr(lane_file(device).string()), HasSubstr(reason), HasSubstr("tyndall devices --calibrate")));
        EXPECT_EQ(file_bytes(lane_file(device)), text) << "it is left alone";
    }
    TemporaryFolder folder;
    EnvironmentVariable config{"XDG_CONFIG_HOME", (folder / "config").c_str()};
    DeviceInfo device{.platform = "Platform", .name = "Name", .driver = "1.0", .version = "OpenCL 3.0", .default_lanes = 16};
    LaneChoice choice{.lanes = 8, .by_rule = 16, .scores = {{8, {1.2, 1.1, 1.3}}, {16, {1, .9, 1.05}}}};
};

TEST_F(LaneStore, NothingIsKeptAtFirst)
{
    EXPECT_EQ(stored_lanes(device).lanes, 0);
    EXPECT_EQ(stored_lanes(device).warning, "");
}

TEST_F(LaneStore, KeepsOneChoicePerDeviceAndDriver)
{
    const fs::path file = store_lanes(device, choice);
    EXPECT_EQ(file.parent_path(), folder / "config/tyndall");
    EXPECT_EQ(stored_lanes(device).lanes, 8);
    EXPECT_EQ(stored_lanes(device).warning, "");
    DeviceInfo driver = device, name = device, version = device;
    driver.driver = "1.1", name.name = "Other", version.version = "OpenCL 1.2";
    for (const DeviceInfo& other : {driver, name, version}) EXPECT_EQ(stored_lanes(other).lanes, 0);
    choice.lanes = 4;
    store_lanes(driver, choice);
    EXPECT_EQ(stored_lanes(driver).lanes, 4);
    EXPECT_EQ(stored_lanes(device).lanes, 8);
    choice.lanes = 16;
    store_lanes(device, choice);
    EXPECT_EQ(stored_lanes(device).lanes, 16);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "config/tyndall"), fs::directory_iterator()), 2) << "no temporary files stay";
}

TEST_F(LaneStore, AFileThatSaysSomethingElseIsIgnoredWithAWarning)
{
    const std::string good = file_bytes(store_lanes(device, choice));
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        EXPECT_NE(text.find(what), std::string::npos) << what;
        return text.replace(text.find(what), what.size(), instead);
    };
    expect_ignored("", "no JSON");
    expect_ignored(good.substr(0, good.size() / 2), "no JSON");
    expect_ignored("[8]", "no JSON");
    expect_ignored(with("tyndall-lanes/1", "tyndall-lanes/2"), "schema");
    expect_ignored(with("\"lanes\": 8", "\"lanes\": 3"), "1, 4, 8 or 16");
    expect_ignored(with("\"lanes\": 8", "\"lanes\": \"8\""), "1, 4, 8 or 16");
    expect_ignored(with("\"driver\": \"1.0\"", "\"driver\": \"0.9\""), "another device");
    expect_ignored(std::string(100000, ' ') + good, "no small file");
    write(good);
    EXPECT_EQ(stored_lanes(device).lanes, 8);
    fs::remove(lane_file(device)), fs::create_directory(lane_file(device));
    EXPECT_THAT(stored_lanes(device).warning, HasSubstr("no small file")) << "a folder";
}

TEST_F(LaneStore, AFolderThatCannotBeMadeIsAnError)
{
    std::ofstream(folder / "file") << "x";
    const EnvironmentVariable inside_a_file("XDG_CONFIG_HOME", (folder / "file").c_str());
    EXPECT_THROW(store_lanes(device, choice), IoError);
    EXPECT_EQ(stored_lanes(device).lanes, 0);
}

TEST_F(LaneStore, FolderIsThatOfTheDesktopOrTheHomeFolders)
{
    EXPECT_EQ(config_folder(), folder / "config/tyndall");
    const EnvironmentVariable relative("XDG_CONFIG_HOME", "not/absolute"), home("HOME", "/home/somebody");
    EXPECT_EQ(config_folder(), "/home/somebody/.config/tyndall");
    const EnvironmentVariable none("HOME", nullptr);
    EXPECT_EQ(config_folder(), "");
    EXPECT_EQ(stored_lanes(device).lanes, 0);
    EXPECT_THROW(store_lanes(device, choice), IoError);
}

}  // namespace
}  // namespace tyndall::test
