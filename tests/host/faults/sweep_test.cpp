#include "sweep.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class EveryCall : public testing::TestWithParam<Selection> {
protected:
    ~EveryCall() override { opencl_faults().reset(); }
    Sweep sweep{GetParam()};
};

// A sample, mostly of shortages, which are made up for. slow_sweep_test.cpp has every call with several codes.
TEST_P(EveryCall, MayFailOnce)
{
    const long calls = sweep.calls(false);
    ASSERT_GT(calls, 50);
    const long step = GetParam() == Selection::all ? 2 : 9;
    for (long n = 0; n < calls; n += step) sweep.fail(n, -5, false, false);
    for (long n = 1, run = 1; n < calls; n += 4 * step, ++run) sweep.fail(n, sweep_codes[static_cast<std::size_t>(run) % std::size(sweep_codes)], false, run % 4 == 3);
    EXPECT_GT(sweep.same(), 2);
    EXPECT_GT(sweep.failed(), 2);
}

TEST_P(EveryCall, MayFailToTell)
{
    const long calls = sweep.calls(true);
    for (long n = 1, run = 0; n < calls; n += 29, ++run) sweep.fail(n, sweep_codes[static_cast<std::size_t>(run) % std::size(sweep_codes)], false, false);
    EXPECT_GT(sweep.same() + sweep.failed(), 2);
}

TEST_P(EveryCall, MayBeTheEndOfTheDevice)
{
    const long calls = sweep.calls(true);
    for (long n = 4, run = 0; n < calls; n += 31, ++run) sweep.fail(n, sweep_codes[static_cast<std::size_t>(run) % std::size(sweep_codes)], true, run % 2 == 1);
    EXPECT_GT(sweep.failed(), 2);
}

INSTANTIATE_TEST_SUITE_P(Of, EveryCall, testing::Values(Selection::all, Selection::tile), [](const auto& info) { return info.param == Selection::all ? "AllLights" : "ChosenLights"; });

}  // namespace
