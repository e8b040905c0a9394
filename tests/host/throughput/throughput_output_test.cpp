// What was measured, as people and programs read it.
#include "throughput/throughput_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "results.hpp"

namespace tyndall::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(ThroughputOutput, SpeedUpIsTheMedianOfTheRoundsOwnRatios)
{
    const auto speedup = speedup_over_scalar(two_kernels());
    ASSERT_TRUE(speedup);
    EXPECT_DOUBLE_EQ(speedup->median, 20);
    EXPECT_DOUBLE_EQ(speedup->low, 20);
    EXPECT_DOUBLE_EQ(speedup->high, 25);
}

TEST(ThroughputOutput, OverlappingRangesAreNotRanked)
{
    ThroughputResult result = two_kernels();
    EXPECT_THAT(fastest_lanes(result, "henyey_greenstein"), ElementsAre(16, 8));
    EXPECT_THAT(fastest_lanes(result, "surface_points"), ElementsAre(16));
    EXPECT_THAT(to_table(result), AllOf(HasSubstr("16 lanes; no difference measured to 8\n"), HasSubstr("(140 M – 151 M)       16 lanes\n")));
    result.rates[0] = rate("henyey_greenstein", 0, {4e6, 4.2e6, 81e6});
    EXPECT_FALSE(speedup_over_scalar(result));
    EXPECT_THAT(to_table(result), HasSubstr("speed-up over the scalar kernel: no difference measured"));
    EXPECT_EQ(json::parse(to_json(result, "v"))["speedup_over_scalar"], nullptr);
}

TEST(ThroughputOutput, JsonHasMediansAndRangesUnderAVersionedSchema)
{
    const json out = json::parse(to_json(two_kernels(), "1.2 (abc)"));
    EXPECT_EQ(out["schema"], "tyndall-bench/1");
    EXPECT_EQ(out["version"], "1.2 (abc)");
    EXPECT_DOUBLE_EQ(out["speedup_over_scalar"].get<double>(), 20);
    EXPECT_EQ(out["clock"], "processor");
    EXPECT_EQ(out["device"]["default_lanes"], 16);
    const json& kernel = out["kernels"][0];
    EXPECT_EQ(kernel["kernel"], "henyey_greenstein");
    EXPECT_EQ(kernel["scalar_pairs_per_second"]["median"], 4e6);
    EXPECT_EQ(kernel["lanes"][1]["lanes"], 16);
    EXPECT_EQ(kernel["lanes"][1]["pairs_per_second"]["low"], 80e6);
    EXPECT_EQ(kernel["fastest_lanes"], (json{16, 8}));
    EXPECT_EQ(out["kernels"][1]["scalar_pairs_per_second"], nullptr);
}

TEST(ThroughputOutput, SaysWhichTimeAndPrintsNoEscapeCodes)
{
    ThroughputResult result = two_kernels();
    EXPECT_THAT(to_table(result), AllOf(HasSubstr("processor time of one core"), Not(HasSubstr("\x1b"))));
    result.processor_time = false, result.cores = Cores::all;
    EXPECT_THAT(to_table(result), HasSubstr("time on the wall, all compute units"));
    result.cores = Cores::one, result.device.is_cpu = false;
    EXPECT_THAT(to_table(result), HasSubstr("time on the wall of the whole device"));
    result.default_lanes = 4;
    EXPECT_THAT(to_table(result), HasSubstr("not measured, 4 lanes are not among --lanes"));
}

TEST(ThroughputOutput, AChoiceSaysWhetherADifferenceWasMeasured)
{
    const ThroughputResult result = two_kernels();
    EXPECT_THAT(to_table(choose_lanes(result, 16), result), HasSubstr("16 lanes, those of the rule, measured to be the fastest"));
    EXPECT_THAT(to_table(choose_lanes(result, 8), result), HasSubstr("16 lanes, measured to be faster than the 8 of the rule"));
    LaneChoice tie = choose_lanes(result, 16);
    tie.rule_is_fastest = false;
    EXPECT_THAT(to_table(tie, result), HasSubstr("16 lanes, those of the rule: no difference measured to the fastest"));
}

}  // namespace
}  // namespace tyndall::test
