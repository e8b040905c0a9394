#include "image_comparison.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tyndall::test {
namespace {

/// splitmix64, so that a script in another language makes the same images to the last bit.
std::uint64_t mixed(std::uint64_t z)
{
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Uniform in [-.5, .5).
double noise(std::uint64_t n) { return static_cast<double>(mixed(n) >> 11) * 0x1p-53 - .5; }

constexpr int width = 28, height = 20;  // not a multiple of the block: four rows and columns are left out

double base(int x, int y, int c) { return x < 8 && y < 8 ? .001 : (1 + x * .125 + y * .0625) * (c + 1) * .25; }

template <class Value>
ImageRgb image_of(Value&& value)
{
    ImageRgb image{width, height, std::vector<Vec3>(width * height)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = value(x, y, c, static_cast<std::uint64_t>((y * width + x) * 3 + c));
    return image;
}

/// A render: pixel noise of `amplitude`, and noise that all its pixels share, as with shared virtual lights.
ImageRgb render_like(std::uint64_t run, double scale, double amplitude, double common)
{
    return image_of([&](int x, int y, int c, std::uint64_t n) {
        return base(x, y, c) * (scale * (1 + amplitude * noise(run * 1000000 + n) + common * noise(900000000 + run)));
    });
}

std::vector<ImageRgb> renders(std::uint64_t first, double scale, double amplitude, double common)
{
    std::vector<ImageRgb> runs;
    for (std::uint64_t run = 0; run < 8; ++run) runs.push_back(render_like(first + run, scale, amplitude, common));
    return runs;
}

ImageRgb reference()
{
    return image_of([](int x, int y, int c, std::uint64_t n) { return base(x, y, c) * (1 + .01 * noise(500000000 + n)); });
}

ImageRgb reference_error()
{
    return image_of([](int x, int y, int c, std::uint64_t) { return .003 * base(x, y, c); });
}

/// What an independent program (numpy, scipy) says of the same images.
struct Expected {
    double scale, relative_mse, bias, bias_half_width, chi_squared, z_share, largest_z, dark;
    bool passed;
};

class AgainstIndependentProgram : public testing::TestWithParam<Expected> {};

TEST_P(AgainstIndependentProgram, GivesTheSameNumbers)
{
    const auto& expected = GetParam();
    const auto result = compare_images(renders(1, expected.scale, .2, .02), reference(), reference_error());
    SCOPED_TRACE(to_string(result));
    // Sums of some thousand doubles in another order: 1e-12 relative; the quantiles of two libraries: 1e-9.
    EXPECT_NEAR(result.relative_mse, expected.relative_mse, 1e-9 * expected.relative_mse);
    EXPECT_NEAR(result.bias, expected.bias, 1e-11);
    EXPECT_NEAR(result.bias_half_width, expected.bias_half_width, 1e-9 * expected.bias_half_width);
    EXPECT_NEAR(result.chi_squared, expected.chi_squared, 1e-7 * expected.chi_squared);
    EXPECT_DOUBLE_EQ(result.z_share, expected.z_share);
    EXPECT_NEAR(result.largest_z, expected.largest_z, 1e-7 * expected.largest_z);
    EXPECT_NEAR(result.dark_difference, expected.dark, 1e-12);
    EXPECT_EQ(result.lit_blocks, 5);
    EXPECT_EQ(result.passed(), expected.passed);
}

INSTANTIATE_TEST_SUITE_P(CompareImages, AgainstIndependentProgram,
                         testing::Values(Expected{1.0, 0.00037575063457446865, -0.0011256088127280517, 0.004920714111329418,
                                                  0.025934114411631792, 0, 0.22124711382765402, 1.717764503471258e-06, true},
                                         Expected{1.03, 0.0011540948565683365, 0.028840622922889914, 0.005067571822246918,
                                                  4.907907772022794, 0, 2.345991408365225, 1.7643731555462174e-05, false},
                                         Expected{1.1, 0.009136204027691067, 0.09876183030599894, 0.005410319241065515, 17.42957978792341,
                                                  1, 4.2344059934266465, 6.282055569297327e-05, false}));

/// Pixel noise .2 uniform: .058 deviation; a block of 192 values of 8 runs: .058 / sqrt(192 * 8) = .15 %. Common noise .04 uniform: .0115 /
/// sqrt 8 = .41 %. Together .44 % block error, as the image tests demand (<= .6 %).
TEST(CompareImages, PassesCorrectImages)
{
    int failures = 0;
    for (std::uint64_t trial = 0; trial < 100; ++trial)
        failures += !compare_images(renders(1000 + 8 * trial, 1, .2, .04), reference(), reference_error()).passed();
    // Below 1 % each by design; five or more of 100 then have probability < .4 %, and the seeds are fixed.
    EXPECT_LE(failures, 4);
}

TEST(CompareImages, FailsAPlantedErrorOfThreePercent)
{
    for (const double scale : {.97, 1.03})
        for (std::uint64_t trial = 0; trial < 50; ++trial) {
            const auto result = compare_images(renders(1000 + 8 * trial, scale, .2, .04), reference(), reference_error());
            EXPECT_FALSE(result.passed()) << "scale " << scale << ", trial " << trial << "\n" << to_string(result);
        }
}

TEST(CompareImages, FailsOneBlockThatIsWrongByAFifth)
{
    auto runs = renders(1, 1, .02, .0);
    for (auto& run : runs)
        for (int y = 8; y < 16; ++y)
            for (int x = 8; x < 16; ++x) run.at(x, y) *= 1.2;
    const auto result = compare_images(runs, reference(), reference_error());
    EXPECT_FALSE(result.passed());
    EXPECT_GT(result.chi_squared, 1.6);
    EXPECT_GT(result.z_share, .03);
}

TEST(CompareImages, FailsLightInDarkBlocks)
{
    auto runs = renders(1, 1, .02, .0);
    for (auto& run : runs)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) run.at(x, y) += Vec3(.05);
    const auto result = compare_images(runs, reference(), reference_error());
    EXPECT_GT(result.dark_difference, .02);
    EXPECT_FALSE(result.passed());
}

TEST(CompareImages, CountsValuesThatAreNotFiniteOrNegative)
{
    auto runs = renders(1, 1, .02, .0);
    runs[2].at(20, 10).x = std::numeric_limits<double>::quiet_NaN();
    runs[3].at(20, 11).y = -std::numeric_limits<double>::infinity();
    runs[4].at(20, 12).z = -1e-9;
    const auto result = compare_images(runs, reference(), reference_error());
    EXPECT_EQ(result.not_finite, 2);
    EXPECT_EQ(result.negative, 1);
    EXPECT_FALSE(result.passed());
}

TEST(CompareImages, FailsWhenNoiseHidesTheAnswer)
{
    const auto result = compare_images(renders(1, 1, .2, .4), reference(), reference_error());
    EXPECT_GT(result.bias_half_width, .02);
    EXPECT_FALSE(result.passed());
}

TEST(CompareImages, FailsBlackAgainstBlack)
{
    const ImageRgb black{width, height, std::vector<Vec3>(width * height, Vec3(0))};
    EXPECT_FALSE(compare_images(std::vector<ImageRgb>(3, black), black, {}).passed());
}

TEST(CompareImages, RefusesFewerThanThreeRunsAndOtherSizes)
{
    const auto runs = renders(1, 1, .2, .02);
    EXPECT_THROW(compare_images(std::span(runs).first(2), reference(), {}), std::invalid_argument);
    const ImageRgb small{8, 8, std::vector<Vec3>(64, Vec3(1))};
    EXPECT_THROW(compare_images(runs, small, {}), std::invalid_argument);
}

}  // namespace
}  // namespace tyndall::test
