#include "sweep.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

constexpr long parts = 8;

/// The lights that eyes are connected to, and which of the parts: every eighth call from there.
struct Part {
    Selection selection;
    long first;
};
void PrintTo(const Part& part, std::ostream* out) { *out << part.first; }

// Four codes for each call, others for the next one.
class EveryCallAndCode : public testing::TestWithParam<Part> {
protected:
    ~EveryCallAndCode() override { opencl_faults().reset(); }
};

TEST_P(EveryCallAndCode, MayFail)
{
    const auto [selection, first] = GetParam();
    Sweep sweep(selection);
    const long calls = sweep.calls(true);
    ASSERT_GT(calls, 8 * parts);
    RecordProperty("calls", static_cast<int>(calls));
    for (long n = first; n < calls; n += parts)
        for (const long way : {0l, 1l, 2l, 3l}) sweep.fail(n, sweep_codes[static_cast<std::size_t>(4 * n + way + n / 2) % std::size(sweep_codes)], way / 2 == 1, way % 2 == 1);
    EXPECT_GT(sweep.same(), 4) << "shortages at launches are made up for";
    EXPECT_GT(sweep.failed(), 12);
}

std::vector<Part> all_parts()
{
    std::vector<Part> all;
    for (const Selection selection : {Selection::all, Selection::tile})
        for (long first = 0; first < parts; ++first) all.push_back({selection, first});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Of, EveryCallAndCode, testing::ValuesIn(all_parts()),
                         [](const auto& info) { return (info.param.selection == Selection::all ? "AllLights" : "ChosenLights") + std::to_string(info.param.first); });

}  // namespace
