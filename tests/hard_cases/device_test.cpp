// Every row against its oracle on the device, at every lane width, and the device against the host.
#include <gtest/gtest.h>

#include <map>

#include "device/case_evaluator.hpp"
#include "tests/hard_cases/check_row.hpp"

namespace tyndall::test {
namespace {

/// Building takes a second: once per lane width.
CaseEvaluator& evaluator_of(unsigned lanes)
{
    static Device device;
    static std::map<unsigned, CaseEvaluator> built;
    return built.try_emplace(lanes, device, static_cast<int>(lanes)).first->second;
}

class HardCasesOnDevice : public testing::TestWithParam<unsigned> {
protected:
    Evaluator<float> evaluator() const
    {
        return [this](unsigned sampler, const std::vector<std::array<float, 14>>& in) { return evaluator_of(GetParam()).evaluate(sampler, in); };
    }
};

INSTANTIATE_TEST_SUITE_P(Lanes, HardCasesOnDevice, testing::Values(1u, 4u, 8u, 16u), [](const auto& lanes) { return std::to_string(lanes.param); });

#define HARD_CASE(name, row) \
    TEST_P(HardCasesOnDevice, name) { check_row<float>(row<float>(), evaluator()); }
#include "selftest/rows.inc"

/// Every lane of a group computes what it would compute alone: the same inputs in another order give the same outputs, to the bit.
TEST_P(HardCasesOnDevice, LanesDoNotDependOnTheirNeighbours)
{
    std::vector<std::array<float, 14>> in;
    for (const HardRow<float>& row : {row01<float>(), row04<float>(), row06<float>()})
        for (const HardCase<float>& c : row.cases) in.push_back(c.in);
    const auto forward = evaluator_of(GetParam()).evaluate(SAMPLER_ROD, in);
    std::reverse(in.begin(), in.end());
    auto backward = evaluator_of(GetParam()).evaluate(SAMPLER_ROD, in);
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(forward, backward);
}

}  // namespace
}  // namespace tyndall::test
