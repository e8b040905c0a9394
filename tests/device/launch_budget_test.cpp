/// How large launches are, from what earlier ones took.
#include "device/launch_budget.hpp"

#include <gtest/gtest.h>

namespace tyndall {
namespace {

TEST(LaunchBudget, StartsSmall)
{
    const LaunchBudget budget(.1);
    EXPECT_EQ(budget.items("gather", 100000, 256), LaunchBudget::first_work / 256);
    EXPECT_EQ(budget.items("gather", 100, 256), 100u) << "all of it";
    EXPECT_EQ(budget.items("gather", 100, 1e9), 1u) << "never nothing";
}

TEST(LaunchBudget, AimsAtHalfOfTheBound)
{
    LaunchBudget budget(.1);
    budget.measured("gather", 1e6, .01);  // 10 ns each: 5e6 in 50 ms
    EXPECT_EQ(budget.items("gather", 1u << 30, 1000), 5000u);
    EXPECT_EQ(budget.items("gather", 1u << 30, 999), 5000u) << "5005, in eights";
    EXPECT_FALSE(budget.knows("sample"));
}

TEST(LaunchBudget, ADearLaunchCountsAtOnceACheapOneByAndBy)
{
    LaunchBudget budget(.1);
    budget.measured("gather", 1e6, .01);
    budget.measured("gather", 1e6, .1);
    EXPECT_EQ(budget.items("gather", 1u << 30, 1000), 496u);
    budget.measured("gather", 1e6, .01);
    const std::uint32_t after_one = budget.items("gather", 1u << 30, 1000);
    EXPECT_GT(after_one, 600u);
    EXPECT_LT(after_one, 700u);
    for (int i = 0; i < 40; ++i) budget.measured("gather", 1e6, .01);
    EXPECT_NEAR(budget.items("gather", 1u << 30, 1000), 5000u, 8);
}

TEST(LaunchBudget, LearnsNothingFromAClockThatStandsStill)
{
    LaunchBudget budget(.1);
    budget.measured("gather", 1e6, 0);
    budget.measured("gather", 1e6, -1);
    EXPECT_FALSE(budget.knows("gather"));
}

}  // namespace
}  // namespace tyndall
