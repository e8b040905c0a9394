// What repeated measurements say, and when two of them differ.
#include "throughput/spread.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tyndall::test {
namespace {

using testing::ElementsAre;

TEST(Spread, HasTheMiddleValueAndBothEnds)
{
    const Spread odd = spread_of({5, 1, 3}), even = spread_of({4, 1, 3, 100}), one = spread_of({7});
    EXPECT_EQ(odd.median, 3);
    EXPECT_EQ(odd.low, 1);
    EXPECT_EQ(odd.high, 5);
    EXPECT_EQ(even.median, 3.5);
    EXPECT_EQ(even.low, 1);
    EXPECT_EQ(even.high, 100);
    EXPECT_EQ(one.median, 7);
    EXPECT_EQ(one.low, 7);
    EXPECT_EQ(one.high, 7);
}

TEST(Spread, RangesThatTouchAreNoDifference)
{
    const Spread low{1, .9, 1.1}, touching{1.2, 1.1, 1.3}, above{1.3, 1.11, 1.4};
    EXPECT_FALSE(measured_above(touching, low));
    EXPECT_FALSE(measured_above(low, touching));
    EXPECT_TRUE(measured_above(above, low));
    EXPECT_FALSE(measured_above(low, above));
    EXPECT_FALSE(measured_above(above, touching)) << "the higher median alone says nothing";
}

TEST(Spread, WhateverOverlapsTheBestIsUnbeaten)
{
    const Spread all[] = {{1, .9, 1.1}, {3, 2.5, 3.5}, {2.4, 2, 2.6}, {2.3, 2.2, 2.4}};
    EXPECT_THAT(unbeaten(all), ElementsAre(1u, 2u));
    const Spread alone[] = {{1, 1, 1}};
    EXPECT_THAT(unbeaten(alone), ElementsAre(0u));
}

}  // namespace
}  // namespace tyndall::test
