#include "sweep.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

// Four codes for each call, others for the next one.
class EveryCallAndCode : public testing::TestWithParam<Selection> {
protected:
    ~EveryCallAndCode() override { opencl_faults().reset(); }
};

TEST_P(EveryCallAndCode, MayFail)
{
    Sweep sweep(GetParam());
    const long calls = sweep.calls(true);
    for (long n = 0, run = 0; n < calls; ++n)
        for (const bool for_ever : {false, true})
            for (const bool late : {false, true}) sweep.fail(n, sweep_codes[static_cast<std::size_t>(run++ + n / 2) % std::size(sweep_codes)], for_ever, late);
    EXPECT_GT(sweep.same(), 100);
    EXPECT_GT(sweep.failed(), 100);
}

INSTANTIATE_TEST_SUITE_P(Of, EveryCallAndCode, testing::Values(Selection::all, Selection::tile), [](const auto& info) { return info.param == Selection::all ? "AllLights" : "ChosenLights"; });

}  // namespace
