// Voxels out of .vol files: what is read, and every way in which a file can lie.
#include "scene/volume_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/vol_file.hpp"

namespace tyndall::test {
namespace {

std::string vol_fault(const std::string& bytes)
{
    try {
        read_vol(bytes);
    } catch (const VolumeFault& fault) {
        return fault.what();
    }
    return "";
}
std::string fault_of(const VolFile& file) { return vol_fault(vol_bytes(file)); }

TEST(VolFile, XRunsFastestAndChannelsComeApart)
{
    VolFile file{.size = {2, 3, 4}, .channels = 3, .box = {-1, -2, -3, 4, 5, 6}};
    for (int i = 0; i < 2 * 3 * 4 * 3; ++i) file.values.push_back(static_cast<float>(i));
    const VolumeFile read = read_vol(vol_bytes(file));
    EXPECT_EQ(read.size_x, 2);
    EXPECT_EQ(read.size_y, 3);
    EXPECT_EQ(read.size_z, 4);
    ASSERT_EQ(read.channels, 3);
    EXPECT_EQ(read.box, file.box);
    for (int c = 0; c < 3; ++c)
        for (int z = 0; z < 4; ++z)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 2; ++x) EXPECT_EQ(read.values[((c * 4 + z) * 3 + y) * 2 + x], file.values[((z * 3 + y) * 2 + x) * 3 + c]);
}

TEST(VolFile, ThreeEqualChannelsAreOne)
{
    VolFile file{.size = {2, 1, 1}, .channels = 3, .values = {1, 1, 1, 7, 7, 7}};
    EXPECT_EQ(read_vol(vol_bytes(file)).channels, 1);
    EXPECT_EQ(read_vol(vol_bytes(file)).values, (std::vector<float>{1, 7}));
    file.values.back() = 8;
    EXPECT_EQ(read_vol(vol_bytes(file)).channels, 3);
    file.values = {1, 2, 1, 7, 7, 7};
    EXPECT_EQ(read_vol(vol_bytes(file)).channels, 3);
}

TEST(VolFile, NegativeZeroIsZero)
{
    EXPECT_FALSE(std::signbit(read_vol(vol_bytes(two_voxels(-0.f, 1))).values[0]));
}

TEST(VolFile, HeaderThatIsWrongIsASentence)
{
    const std::string good = vol_bytes(two_voxels(1, 2));
    EXPECT_EQ(vol_fault(""), "has 0 bytes; a .vol file starts with a header of 48");
    EXPECT_EQ(vol_fault(good.substr(0, 47)), "has 47 bytes; a .vol file starts with a header of 48");
    EXPECT_EQ(vol_fault("VOX" + good.substr(3)), "does not start with the letters VOL; it is no .vol file");
    EXPECT_EQ(fault_of({.version = 2}), "is of version 2; only version 3 is read");
    EXPECT_EQ(fault_of({.version = 255}), "is of version 255; only version 3 is read");
    EXPECT_EQ(fault_of({.encoding = 2}), "has encoding 2; only 1, 32-bit float, is read");
    for (const std::int32_t channels : {0, 2, 4, 6, -1, std::numeric_limits<std::int32_t>::min()})
        EXPECT_EQ(fault_of({.channels = channels, .values = {1}}), "has " + std::to_string(channels) + " channels; it must have 1 or 3");
    for (int axis = 0; axis < 3; ++axis)
        for (const std::int32_t size : {0, -1, std::numeric_limits<std::int32_t>::min()}) {
            VolFile file{.values = {1}};
            file.size[axis] = size;
            EXPECT_NE(fault_of(file).find("; every size must be at least 1"), std::string::npos) << fault_of(file);
        }
}

TEST(VolFile, SizesThatTheBytesDoNotBearOutAreRefusedBeforeMemoryIsAskedFor)
{
    const std::string good = vol_bytes(two_voxels(1, 2));
    EXPECT_EQ(vol_fault(good), "");
    EXPECT_EQ(vol_fault(good.substr(0, good.size() - 1)),
              "says that it holds 2 x 1 x 1 voxels of 1 channels, but 7 bytes follow its header; it is truncated, or its sizes are wrong");
    for (std::size_t size = 0; size < good.size(); ++size) EXPECT_NE(vol_fault(good.substr(0, size)), "") << size;
    for (const std::string& more : std::vector<std::string>{"x", "xxxx", "xxxxxxxx"}) EXPECT_NE(vol_fault(good + more), "") << more;
    const std::int32_t most = std::numeric_limits<std::int32_t>::max(), k = 1 << 16, l = 1 << 21;
    // 2^16 x 2^16 and 2^21 x 2^21 x 2^21 x 2 are 0 modulo 2^32 and 2^64, as is the third's number of bytes.
    for (const std::array<std::int32_t, 3> size : {std::array{most, most, most}, {k, k, 1}, {l, l, 1 << 22}, {1 << 30, 1 << 30, 4}, {1, most, 1}, {1, 1, most}, {k, 1, k}})
        for (const std::int32_t channels : {1, 3})
            for (const std::vector<float>& values : {std::vector<float>{}, {1}, {1, 2, 3}})
                EXPECT_NE(fault_of({.size = size, .channels = channels, .values = values}).find("sizes are wrong"), std::string::npos);
}

TEST(VolFile, ValuesThatNoMediumHasAreRefusedByVoxel)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const auto with = [](float value) {
        VolFile file{.size = {2, 3, 4}, .channels = 3, .values = std::vector<float>(72, .5f)};
        file.values[((3 * 3 + 2) * 2 + 1) * 3 + 2] = value;
        return fault_of(file);
    };
    EXPECT_EQ(with(.5f), "");
    EXPECT_EQ(with(-.25f), "voxel (1, 2, 3) is -0.25; every value must be finite and not negative");
    EXPECT_EQ(with(inf), "voxel (1, 2, 3) is inf; every value must be finite and not negative");
    EXPECT_EQ(with(-inf), "voxel (1, 2, 3) is -inf; every value must be finite and not negative");
    EXPECT_NE(with(nan).find("voxel (1, 2, 3) is nan"), std::string::npos);
    EXPECT_NE(with(-nan).find("voxel (1, 2, 3) is -nan"), std::string::npos);
}

TEST(VolFile, RandomDamageIsRefusedOrRead)
{
    // 20000 files with a few bits turned over: voxels that keep every promise of VolumeFile, or a VolumeFault.
    std::mt19937 random(11);
    const std::string good = vol_bytes(ball_of_smoke(3));
    int refused = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        std::string bytes = good;
        for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips) {
            const std::size_t header = 48, at = random() % (random() % 2 ? header : bytes.size());
            bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
        }
        if (!vol_fault(bytes).empty()) {
            ++refused;
            continue;
        }
        const VolumeFile file = read_vol(bytes);
        ASSERT_EQ(file.values.size(), 27u);
        for (const float value : file.values) ASSERT_TRUE(std::isfinite(value) && value >= 0) << value;
    }
    EXPECT_GT(refused, 5000);
    EXPECT_LT(refused, 15000);
}

}  // namespace
}  // namespace tyndall::test
