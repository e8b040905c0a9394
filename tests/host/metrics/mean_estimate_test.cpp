#include "metrics/mean_estimate.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "metrics/block_means.hpp"
#include "synthetic_image.hpp"

namespace tyndall::test {
namespace {

using testing::DoubleNear;
constexpr double infinity = std::numeric_limits<double>::infinity();

RunningMean running(std::initializer_list<double> values)
{
    RunningMean mean;
    for (const double value : values) mean.add(value);
    return mean;
}

TEST(RunningMean, OfFourNumbersByHand)
{
    const MeanEstimate estimate = running({1, 2, 4, 9}).estimate();  // squares of the distances: 9 + 4 + 0 + 25 = 38
    EXPECT_DOUBLE_EQ(estimate.value, 4);
    EXPECT_DOUBLE_EQ(estimate.variance, 38. / 3 / 4);
    EXPECT_DOUBLE_EQ(estimate.degrees, 3);
}

TEST(RunningMean, OfOneNumberKnowsNoSpread)
{
    const MeanEstimate estimate = running({5}).estimate();
    EXPECT_EQ(estimate.value, 5);
    EXPECT_EQ(estimate.degrees, 0);
    EXPECT_EQ(half_width(estimate, .95), infinity);
}

TEST(RunningMean, MergedIsAsIfAllHadBeenAdded)
{
    RunningMean merged = running({1, 2}), none;
    merged.merge(running({4, 9}));
    merged.merge(none), none.merge(merged);
    for (const auto& mean : {merged, none}) {
        EXPECT_DOUBLE_EQ(mean.estimate().value, 4);
        EXPECT_DOUBLE_EQ(mean.estimate().variance, 38. / 3 / 4);
    }
}

TEST(RunningMean, KeepsItsSpreadFarFromZero)
{
    const MeanEstimate estimate = running({1e9 + 1, 1e9 + 2, 1e9 + 4, 1e9 + 9}).estimate();
    EXPECT_THAT(estimate.variance, DoubleNear(38. / 3 / 4, 1e-6));  // the sum of squares would have lost every digit
}

TEST(NormalDeviate, HasTheTailOfStudentsT)
{
    EXPECT_THAT(normal_deviate(2.364624251592785, 7), DoubleNear(1.959963984540054, 1e-9));  // both .975 quantiles, from tables
    EXPECT_THAT(normal_deviate(-12.706204736174698, 1), DoubleNear(-1.959963984540054, 1e-9));
    EXPECT_EQ(normal_deviate(2.5, infinity), 2.5);
    EXPECT_EQ(normal_deviate(infinity, 5), 37);
    EXPECT_EQ(normal_deviate(0, 5), 0);
}

TEST(Bias, OfTwoMeasuredMeansByHand)
{
    // Welch: variance .0004 + .0005 = .0009, degrees .0009^2 / (.0004^2 / 4 + .0005^2 / 9) = 11.9508...; t = .1 / .03
    const MeanEstimate value{2.1, .0004, 4}, reference{2, .0005, 9};
    EXPECT_DOUBLE_EQ(welch_degrees(value, reference), 8.1e-7 / (1.6e-7 / 4 + 2.5e-7 / 9));
    const Bias bias = bias_of(value, reference);
    EXPECT_DOUBLE_EQ(bias.relative, 2.1 / 2 - 1);
    EXPECT_DOUBLE_EQ(bias.z, normal_deviate((2.1 - 2) / .03, welch_degrees(value, reference)));
    EXPECT_GT(bias.z, 2.6);
    EXPECT_LT(bias.z, 2.9);
}

TEST(Bias, IsUnknownWithoutASpread)
{
    const Bias bias = bias_of({2.2, 0, 0}, {2});
    EXPECT_DOUBLE_EQ(bias.relative, 2.2 / 2 - 1);
    EXPECT_EQ(bias.half_width, infinity);
    EXPECT_FALSE(bias.significant());
}

TEST(Bias, OfExactMeansIsSureOrNone)
{
    EXPECT_TRUE(bias_of({1.5}, {1}).significant());
    EXPECT_EQ(bias_of({1}, {1}).z, 0);
    EXPECT_EQ(bias_of({1}, {0}).z, 0) << "relative to black there is no bias";
}

/// Numbers of an independent script (NumPy and SciPy) for the same images.
struct Expected {
    double bias, half_width, chi_squared, largest_z;
};

void expect_as_elsewhere(std::uint64_t first_run, double scale, const Expected& expected)
{
    const auto reference = reference_image();
    BlockStatistics runs;
    for (std::uint64_t run = 0; run < 8; ++run) runs.add(noisy_render(first_run + run, scale), image_width);
    double mean = 0;
    for (const Rgb& pixel : reference) mean += sum(pixel) / (3. * static_cast<double>(reference.size()));
    const Bias bias = bias_of(runs.whole(), {mean});
    EXPECT_THAT(bias.relative, DoubleNear(expected.bias, 1e-13));
    EXPECT_THAT(bias.half_width, DoubleNear(expected.half_width, 1e-10));
    std::vector<MeanEstimate> blocks;
    for (const double block : block_means(reference, image_width)) blocks.push_back({block});
    const BlockBias result = block_bias(runs, blocks);
    EXPECT_EQ(result.lit_blocks, 5);
    EXPECT_THAT(result.chi_squared, DoubleNear(expected.chi_squared, 1e-8));
    EXPECT_THAT(std::abs(result.largest_z), DoubleNear(expected.largest_z, 1e-8));
    EXPECT_EQ(result.beyond_three, 0);
    ASSERT_EQ(result.z.size(), 6u);
    EXPECT_TRUE(std::isnan(result.z[0])) << "the dark block";
    EXPECT_EQ(result.z[static_cast<std::size_t>(result.largest_block)], result.largest_z);
}

TEST(Bias, OfRunsAndBlocksAgreesWithAnotherProgram)
{
    expect_as_elsewhere(0, 1, {-0.0009916426238210096, 0.011853343490042753, 0.11222292552700971, 0.5117718048819965});
    expect_as_elsewhere(20, 1.02, {0.016615652256961155, 0.014694521198084759, 4.571650612571091, 2.239281909023662});
}

TEST(BlockMeans, OfWholeBlocksByHand)
{
    std::vector<Rgb> image(17 * 9, Rgb(100));  // the last column and row belong to no block
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) image[static_cast<std::size_t>(y * 17 + x)] = x < 8 ? Rgb(1, 2, 3) : Rgb(x == 8 && y == 0 ? 64 : 0);
    EXPECT_THAT(block_means(image, 17), testing::ElementsAre(2, 1));
    EXPECT_THAT(block_means(std::vector<Rgb>(7 * 7, Rgb(1)), 7), testing::IsEmpty());
}

TEST(BlockMeans, RelativeErrorByHand)
{
    std::vector<Rgb> reference(16 * 8, Rgb(1)), image(16 * 8, Rgb(1.5));   // blocks of 1 and 3, mean 2, e = .01; seen as 1.5 and 2
    for (int y = 0; y < 8; ++y)
        for (int x = 8; x < 16; ++x) reference[static_cast<std::size_t>(y * 16 + x)] = Rgb(3), image[static_cast<std::size_t>(y * 16 + x)] = Rgb(1 + (x + y) % 2 * 2.);
    EXPECT_DOUBLE_EQ(blocks_relative_mse(image, reference, 16), (.25 / 1.01 + 1 / 9.01) / 2);
    EXPECT_EQ(blocks_relative_mse(reference, reference, 16), 0);
    EXPECT_TRUE(std::isnan(blocks_relative_mse(std::vector<Rgb>(7, Rgb(1)), std::vector<Rgb>(7, Rgb(1)), 7)));
}

TEST(Median, IsTheMiddle)
{
    EXPECT_EQ(median(std::vector{3., 1., 2.}), 2);
    EXPECT_EQ(median(std::vector{4., 1., 2., 3.}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
}

}  // namespace
}  // namespace tyndall::test
