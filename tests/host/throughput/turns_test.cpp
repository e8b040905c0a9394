// Measuring in turns, by a clock that moves only when a task says so.
#include "throughput/turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "throughput/spread.hpp"

namespace tyndall::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

/// Two tasks, a of 1 s and b of 3 s, that take `slow` times as long in their third turn.
class Turns : public testing::Test {
protected:
    std::vector<std::vector<double>> measure(const TurnPlan& plan)
    {
        const std::function<void()> tasks[] = {[&] { take('a', 1); }, [&] { take('b', 3); }};
        return seconds_in_turns(tasks, plan, [&] { return now; }, [&] { return 2 * now; });
    }
    void take(char name, double seconds)
    {
        order += name;
        now += seconds * (order.size() > 4 && order.size() < 7 ? slow : 1);
    }
    double now = 100, slow = 1;
    std::string order;
};

TEST_F(Turns, TakesEveryTaskOncePerRoundAndTurnsTheOrderAround)
{
    const auto seconds = measure({.least_rounds = 4, .most_rounds = 4, .seconds = 1e9});
    EXPECT_EQ(order, "abbaabba");
    EXPECT_THAT(seconds, ElementsAre(ElementsAre(1, 1, 1, 1), ElementsAre(3, 3, 3, 3)));
}

TEST_F(Turns, StopsBeforeARoundThatWouldEndTooLateByTheOtherClock)
{
    EXPECT_THAT(measure({.least_rounds = 1, .most_rounds = 50, .seconds = 24}), Each(SizeIs(3))) << "a round takes 8 s there";
    order.clear();
    EXPECT_THAT(measure({.least_rounds = 5, .most_rounds = 50, .seconds = 1}), Each(SizeIs(5))) << "not before the least number";
    order.clear();
    EXPECT_THAT(measure({.least_rounds = 1, .most_rounds = 7, .seconds = 1e9}), Each(SizeIs(7)));
}

TEST_F(Turns, ADisturbanceMeetsBothAndIsSeenInTheRangeAlone)
{
    slow = 5;
    const auto seconds = measure({.least_rounds = 5, .most_rounds = 5});
    const Spread a = spread_of(seconds[0]), b = spread_of(seconds[1]);
    EXPECT_EQ(a.median, 1);
    EXPECT_EQ(a.high, 5);
    EXPECT_EQ(b.median, 3);
    EXPECT_EQ(b.high, 15);
    EXPECT_FALSE(measured_above(b, a)) << "3 to 15 overlaps 1 to 5: no difference is claimed";
    for (std::size_t round = 0; round < 5; ++round) EXPECT_EQ(seconds[1][round] / seconds[0][round], 3) << "the ratio within a round keeps it out";
}

}  // namespace
}  // namespace tyndall::test
