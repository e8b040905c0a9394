// The kernels that are measured compute what the scalar kernel computes, and measuring them gives numbers.
#include "throughput/measured_kernels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "throughput/throughput.hpp"

namespace tyndall::test {
namespace {

TEST(MeasuredKernels, AgreementIsAShareOfSumsAndNeedsTheMeans)
{
    const std::vector<double> sums(100, 2.);
    std::vector<double> one_off = sums, all_off = sums;
    one_off[3] = 2.1;
    for (double& value : all_off) value *= 1.02;
    EXPECT_EQ(agreeing_sums(sums, sums), 1);
    EXPECT_EQ(agreeing_sums(sums, one_off), .99);
    EXPECT_EQ(agreeing_sums(sums, all_off), 0);
}

TEST(MeasuredKernels, EyesAreRepeatedForLargeDevices)
{
    const MeasuredKernel& grid = measured_kernels().back();
    const Workload few = workload_of(grid, 1), many = workload_of(grid, 5000);
    EXPECT_EQ(few.eyes.size(), 2048u);
    ASSERT_GE(many.eyes.size(), 5000u);
    EXPECT_EQ(many.eyes.size() % eye_alignment, 0u);
    EXPECT_EQ(many.points.size(), many.eyes.size());
    EXPECT_EQ(many.eyes[4100].direction_x, few.eyes[4].direction_x);
    for (const EyeSegment& eye : many.eyes) EXPECT_GT(eye.length, 0) << "every ray crosses the box";
}

TEST(MeasuredKernels, RunOnADeviceInTurnsAndAgreeWithTheScalarKernel)
{
    const ThroughputResult result = measure_throughput({.lanes = {4, 16}, .kernels = {"henyey_greenstein", "surface_points"}, .default_lanes = 16, .seconds = .5});
    ASSERT_EQ(result.rates.size(), 5u);
    EXPECT_GE(result.rounds, 5);
    EXPECT_GE(result.agreeing.value_or(0), .99);
    for (const KernelRate& rate : result.rates) {
        EXPECT_EQ(rate.rates.size(), static_cast<std::size_t>(result.rounds));
        EXPECT_GT(rate.pairs_per_second.low, 0) << rate.kernel;
    }
}

}  // namespace
}  // namespace tyndall::test
