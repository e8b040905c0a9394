// The lane width that made-up measurements call for.
#include "throughput/lane_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "results.hpp"

namespace tyndall::test {
namespace {

ThroughputResult of_widths(std::vector<std::vector<double>> rates)
{
    ThroughputResult result;
    const int widths[] = {1, 4, 8, 16};
    for (std::size_t i = 0; i < rates.size(); ++i) result.rates.push_back(rate("a", widths[i], rates[i]));
    return result;
}

TEST(LaneChoice, TakesTheWidthThatIsMeasuredToBeFaster)
{
    const LaneChoice choice = choose_lanes(of_widths({{5, 5, 5}, {30, 31, 32}, {60, 61, 62}, {40, 41, 42}}), 16);
    EXPECT_EQ(choice.lanes, 8);
    EXPECT_EQ(choice.by_rule, 16);
    EXPECT_FALSE(choice.rule_is_fastest);
    ASSERT_EQ(choice.scores.size(), 4u);
    EXPECT_NEAR(choice.scores[2].speed.median, 61. / 41, 1e-12);
    EXPECT_NEAR(choice.scores[3].speed.median, 1, 1e-12);
    EXPECT_NEAR(choice.scores[3].speed.low, 40. / 41, 1e-12);
}

TEST(LaneChoice, KeepsTheRuleWhereNoDifferenceWasMeasured)
{
    const LaneChoice choice = choose_lanes(of_widths({{5, 5, 5}, {30, 31, 32}, {44, 45, 46}, {40, 41, 44}}), 16);
    EXPECT_EQ(choice.lanes, 16) << "8 has the higher median, but its range touches that of 16";
    EXPECT_FALSE(choice.rule_is_fastest);
    EXPECT_TRUE(choose_lanes(of_widths({{5, 5, 5}, {30, 31, 32}}), 4).rule_is_fastest);
}

TEST(LaneChoice, WeighsKernelsByTheirRatiosNotByTheirRates)
{
    ThroughputResult result;  // a thousand times faster kernel wins by 10 % at 8 lanes, a slow one loses by half
    result.rates = {rate("fast", 8, {1100e6}), rate("fast", 16, {1000e6}), rate("slow", 8, {.5e6}), rate("slow", 16, {1e6}), rate("slow", 0, {7e9})};
    const LaneChoice choice = choose_lanes(result, 8);
    EXPECT_EQ(choice.lanes, 16);
    EXPECT_NEAR(choice.scores[1].speed.median, std::sqrt(2 / 1.1), 1e-12);
}

TEST(LaneChoice, AsksAllWidthsOfEverydayKernels)
{
    const ThroughputRequest request = lane_request("some device");
    EXPECT_EQ(request.device, "some device");
    EXPECT_THAT(request.lanes, testing::ElementsAre(1, 4, 8, 16));
    EXPECT_FALSE(request.kernels.empty());
    EXPECT_FALSE(request.baseline);
}

TEST(UsualWidths, LeaveOutWhatOnlyCpusAreFastWith)
{
    DeviceInfo device;
    device.is_cpu = true;
    EXPECT_THAT(usual_widths(device), testing::ElementsAre(1, 4, 8, 16));
    device.is_cpu = false;
    EXPECT_THAT(usual_widths(device), testing::ElementsAre(1, 4));
}

}  // namespace
}  // namespace tyndall::test
