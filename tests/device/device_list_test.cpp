#include "device/device_list.hpp"

#include <gtest/gtest.h>

#include "tyndall/error.hpp"

namespace tyndall {
namespace {

TEST(DeviceList, KnowsAUsableDevice)
{
    const auto devices = list_devices();
    ASSERT_FALSE(devices.empty());
    const DeviceInfo chosen = choose_device("");
    EXPECT_TRUE(chosen.usable);
    EXPECT_GT(chosen.compute_units, 0u);
    EXPECT_TRUE(chosen.default_lanes == 1 || chosen.default_lanes == 4 || chosen.default_lanes == 8 || chosen.default_lanes == 16);
}

TEST(DeviceList, FindsADeviceByIndexNameAndPlatform)
{
    const DeviceInfo first = choose_device("");
    EXPECT_EQ(choose_device(std::to_string(first.index)).name, first.name);
    EXPECT_EQ(choose_device(first.name.substr(1, 5)).index, first.index);
    std::string upper = first.platform.substr(0, 6);
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(choose_device(upper + ":" + first.name).index, first.index);
}

TEST(DeviceList, AnUnknownNameIsRefusedWithTheListOfWhatThereIs)
{
    try {
        choose_device("no such device");
        FAIL();
    } catch (const NoDeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("no such device"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find(list_devices().front().name), std::string::npos);
    }
}

}  // namespace
}  // namespace tyndall
