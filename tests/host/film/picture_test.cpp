#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include "film/png.hpp"
#include "film/tone_map.hpp"
#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using Pixel = std::array<std::uint8_t, 3>;

TEST(ToneMap, IsPlainSrgbBelowTheShoulder)
{
    // sRGB by hand: .5 -> 1.055 * .5^(1/2.4) - .055 = .735357 -> 187.5; .2 -> .484529 -> 123.6; .001 -> .01292 -> 3.3.
    EXPECT_EQ(tone_map(Rgb(.2, .001, 0), 0), (Pixel{124, 3, 0}));
    EXPECT_EQ(tone_map(Rgb(.05, .00025, 0), 2), (Pixel{124, 3, 0}));
}

TEST(ToneMap, ShoulderIsSmoothMonotoneAndEndsAtWhite)
{
    EXPECT_EQ(tone_map(Rgb(1e300, 100, 3), 0), (Pixel{255, 255, 255}));
    // At 1: .8 + .2 (1 - exp(-1)) = .926424 linear -> 1.055 * .926424^(1/2.4) - .055 = .966806 -> 246.5; .99 and 1.01 lie on either side.
    EXPECT_EQ(tone_map(Rgb(.99), 0)[0], 246);
    EXPECT_EQ(tone_map(Rgb(1.02), 0)[0], 247);
    int previous = 0;
    for (double value = 0; value < 3; value += .001) {
        const int now = tone_map(Rgb(value), 0)[0];
        EXPECT_GE(now, previous) << value;
        EXPECT_LE(now - previous, 4) << value;  // 12.92 * 255 * .001 = 3.3 per step at black, less elsewhere
        previous = now;
    }
}

TEST(ToneMap, ShowsNegativeAndNanAsBlack)
{
    EXPECT_EQ(tone_map(Rgb(-1, std::numeric_limits<double>::quiet_NaN(), .2), 0), (Pixel{0, 0, 124}));
}

TEST(AutomaticExposure, BringsThePercentileToItsPlace)
{
    std::vector<Rgb> image(300, Rgb(0));  // black pixels do not count
    for (int i = 1; i <= 101; ++i) image.push_back(Rgb(i));
    EXPECT_NEAR(std::exp2(automatic_exposure(image)) * 96, .7, 1e-12);  // the 95th percentile of 1..101 is 96
    EXPECT_EQ(automatic_exposure(std::vector<Rgb>(4, Rgb(0))), 0);
}

struct Decoded {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};

Decoded decoded(const std::filesystem::path& file)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&png, file.c_str())) << png.message;
    png.format = PNG_FORMAT_RGB;
    Decoded image{static_cast<int>(png.width), static_cast<int>(png.height), std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
    EXPECT_TRUE(png_image_finish_read(&png, nullptr, image.bytes.data(), 0, nullptr)) << png.message;
    return image;
}

TEST(Png, HoldsTheToneMappedPixelsTopRowFirst)
{
    test::TemporaryFolder folder;
    const std::vector<Rgb> image{Rgb(.2, 0, 0), Rgb(0, .2, 0), Rgb(0, 0, .2), Rgb(100), Rgb(0), Rgb(.1)};
    write_png(folder / "a.png", image, 2, 1);
    const auto picture = decoded(folder / "a.png");
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 3);
    ASSERT_EQ(picture.bytes.size(), 18u);
    for (std::size_t i = 0; i < image.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(picture.bytes[3 * i + c], tone_map(image[i], 1)[c]) << i << " " << c;
    EXPECT_EQ(picture.bytes[0], 170);  // .4 -> .665185 -> 169.6
}

TEST(Png, EqualPicturesGiveEqualBytesAndFailuresAreReported)
{
    test::TemporaryFolder folder;
    const std::vector<Rgb> image(12, Rgb(.3));
    write_png(folder / "a.png", image, 4, 0);
    write_png(folder / "b.png", image, 4, 0);
    EXPECT_EQ(test::file_bytes(folder / "a.png"), test::file_bytes(folder / "b.png"));
    EXPECT_THROW(write_png(folder / "no" / "a.png", image, 4, 0), IoError);
}

}  // namespace
}  // namespace tyndall
