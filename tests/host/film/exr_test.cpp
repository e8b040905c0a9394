#include "film/exr.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using test::file_bytes;

/// 5 x 3 pixels at (7, 2) of a 20 x 10 film; two channels.
ExrImage small_image()
{
    ExrImage image{.x = 7, .y = 2, .width = 5, .height = 3, .display_width = 20, .display_height = 10};
    for (int i = 0; i < 15; ++i) {
        image.channels["R"].values.push_back(1.f / static_cast<float>(i + 3));
        image.channels["media_to_media.specular.G"].values.push_back(static_cast<float>(i) * -1e30f);
    }
    image.attributes["tyndall.seed"] = std::string("18446744073709551615");
    image.attributes["tyndall.passes"] = 16;
    image.attributes["tyndall.error"] = .012345678901234567;
    return image;
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

TEST(Exr, RoundTripKeepsEveryValueWindowAndAttribute)
{
    test::TemporaryFolder folder;
    const auto image = small_image();
    write_exr(folder / "a.exr", image);
    const auto read = read_exr(folder / "a.exr");
    EXPECT_EQ(read.x, 7);
    EXPECT_EQ(read.y, 2);
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.display_width, 20);
    EXPECT_EQ(read.display_height, 10);
    ASSERT_EQ(read.channels.size(), 2u);
    for (const auto& [name, channel] : image.channels) {
        EXPECT_EQ(read.channels.at(name).values, channel.values) << name;
        EXPECT_FALSE(read.channels.at(name).half) << name;
    }
    for (const auto& [name, value] : image.attributes) EXPECT_EQ(read.attributes.at(name), value) << name;
}

TEST(Exr, KeepsNotFiniteValuesAsTheyAre)
{
    test::TemporaryFolder folder;
    auto image = small_image();
    image.channels["R"].values[4] = std::numeric_limits<float>::quiet_NaN();
    image.channels["R"].values[5] = std::numeric_limits<float>::infinity();
    write_exr(folder / "a.exr", image);
    const auto read = read_exr(folder / "a.exr");
    EXPECT_TRUE(std::isnan(read.channels.at("R").values[4]));
    EXPECT_TRUE(std::isinf(read.channels.at("R").values[5]));
}

TEST(Exr, HalfKeepsElevenBitsAndIsGivenUpForValuesThatDoNotFit)
{
    test::TemporaryFolder folder;
    auto image = small_image();
    image.channels["R"].half = true;
    image.channels["large"] = {std::vector<float>(15, 1.f), true};
    image.channels["large"].values[3] = 65505.f;
    write_exr(folder / "a.exr", image);
    const auto read = read_exr(folder / "a.exr");
    EXPECT_TRUE(read.channels.at("R").half);
    for (std::size_t i = 0; i < 15; ++i) {
        const float written = image.channels["R"].values[i];
        EXPECT_NEAR(read.channels.at("R").values[i], written, written * 0x1p-11f) << i;  // round to nearest of 11 bits: half a unit
        EXPECT_NE(read.channels.at("R").values[0], image.channels["R"].values[0]);       // 1/3 has more bits than that
    }
    EXPECT_FALSE(read.channels.at("large").half);
    EXPECT_EQ(read.channels.at("large").values[3], 65505.f);
}

TEST(Exr, EqualImagesGiveEqualBytes)
{
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", small_image());
    write_exr(folder / "b.exr", small_image());
    EXPECT_FALSE(file_bytes(folder / "a.exr").empty());
    EXPECT_EQ(file_bytes(folder / "a.exr"), file_bytes(folder / "b.exr"));
}

TEST(Exr, ThreadsNeverChangeAByte)
{
    test::TemporaryFolder folder;
    ExrImage image = small_image();
    image.height = image.display_height = 333;  // many pieces that are compressed by themselves
    for (auto& [name, channel] : image.channels) {
        channel.values.resize(static_cast<std::size_t>(image.width * image.height));
        for (std::size_t i = 0; i < channel.values.size(); ++i) channel.values[i] = std::sin(float(i * i));
    }
    const auto threads = [] { return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}); };
    compress_exr_in_threads(1);
    const auto before = threads();
    write_exr(folder / "alone.exr", image);
    compress_exr_in_threads(3);
    EXPECT_EQ(threads(), before + 3);
    write_exr(folder / "together.exr", image);
    compress_exr_in_threads(1);
    EXPECT_EQ(threads(), before);
    EXPECT_FALSE(file_bytes(folder / "alone.exr").empty());
    EXPECT_EQ(file_bytes(folder / "alone.exr"), file_bytes(folder / "together.exr"));
}

TEST(Exr, RefusesWhatIsMissingOrNoImage)
{
    test::TemporaryFolder folder;
    write_bytes(folder / "text.exr", "this is no image, but it is long enough to hold a header");
    EXPECT_THROW(read_exr(folder / "none.exr"), IoError);
    EXPECT_THROW(read_exr(folder / "text.exr"), IoError);
    EXPECT_THROW(read_exr(folder.path()), IoError);
    EXPECT_THROW(read_exr("/dev/zero"), IoError);
}

TEST(Exr, RefusesEveryTruncation)
{
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", small_image());
    const auto bytes = file_bytes(folder / "a.exr");
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 16) {
        write_bytes(folder / "cut.exr", bytes.substr(0, length));
        EXPECT_THROW(read_exr(folder / "cut.exr"), IoError) << length << " of " << bytes.size() << " bytes";
    }
}

TEST(Exr, RefusesAHeaderThatClaimsTooManyPixels)
{
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", small_image());
    auto bytes = file_bytes(folder / "a.exr");
    const auto window = bytes.find("dataWindow");
    ASSERT_NE(window, std::string::npos);
    // name\0 type "box2i"\0 size(4) xMin yMin xMax yMax: make xMax and yMax some 800,000.
    const auto box = window + sizeof("dataWindow") + sizeof("box2i") + 4;
    for (const std::size_t at : {box + 8, box + 12}) bytes.replace(at, 4, std::string("\x00\x35\x0c\x00", 4));
    write_bytes(folder / "large.exr", bytes);
    EXPECT_THROW(read_exr(folder / "large.exr"), IoError);
}

// Found by tests/fuzz: OpenEXR would take the memory first, 2 GiB for a file of 300 bytes.
TEST(Exr, RefusesAnAttributeLargerThanTheFile)
{
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", small_image());
    const std::string bytes = file_bytes(folder / "a.exr");
    const auto type = bytes.find(std::string("tyndall.seed\0string\0", 20));
    ASSERT_NE(type, std::string::npos);
    for (const std::string& size : {std::string("\xff\xff\xff\x7f"), std::string("\xff\xff\xff\xff"), std::string("\x00\x10\x00\x00", 4)}) {
        write_bytes(folder / "b.exr", std::string(bytes).replace(type + 20, 4, size));
        try {
            read_exr(folder / "b.exr");
            ADD_FAILURE();
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find("claims more bytes in its header than there are"), std::string::npos) << error.what();
        }
    }
}

TEST(Exr, SurvivesEveryFlippedByte)
{
    // Damage may go unnoticed (no checksums), but must end in an image or an IoError.
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", small_image());
    const auto bytes = file_bytes(folder / "a.exr");
    int refused = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        auto damaged = bytes;
        damaged[i] = static_cast<char>(~damaged[i]);
        write_bytes(folder / "damaged.exr", damaged);
        try {
            read_exr(folder / "damaged.exr");
        } catch (const IoError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace tyndall
