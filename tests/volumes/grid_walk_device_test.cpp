// Grids against their oracle on the device, at every lane width.
#include <algorithm>
#include <map>

#include "tests/volumes/check_grid.hpp"
#include "tests/volumes/grid_device.hpp"

namespace tyndall::test {
namespace {

/// Building takes a second: once per lane width.
const GridDevice& device(unsigned lanes)
{
    static std::map<unsigned, GridDevice> built;
    return built.try_emplace(lanes, lanes).first->second;
}

class HardGridsOnDevice : public testing::TestWithParam<unsigned> {
protected:
    GridEvaluator<float> evaluator() const
    {
        return [this](const TestGrid& grid, const std::vector<std::array<float, 6>>& segments) { return device(GetParam()).evaluate(grid, segments); };
    }
};
INSTANTIATE_TEST_SUITE_P(Lanes, HardGridsOnDevice, testing::Values(1u, 4u, 8u, 16u), [](const auto& lanes) { return std::to_string(lanes.param); });

TEST_P(HardGridsOnDevice, Row19EmptyVoxelsGiveZeroAndNothingElse) { check_grids<float>(row19<float>(), evaluator()); }
TEST_P(HardGridsOnDevice, Row20FacesEdgesCornersAndAxisParallelWays) { check_grids<float>(row20<float>(), evaluator()); }
TEST_P(HardGridsOnDevice, Row21TrilinearValuesAreIntegratedExactly) { check_grids<float>(row21<float>(), evaluator()); }

/// Lanes that have finished wait for the others and change nothing: the same inputs in another order give the same outputs, to the bit.
TEST_P(HardGridsOnDevice, LanesDoNotDependOnTheirNeighbours)
{
    for (const GridRow<float>& row : row21<float>()) {
        auto segments = row.segments;
        const auto forward = evaluator()(row.grid, segments);
        std::reverse(segments.begin(), segments.end());
        auto backward = evaluator()(row.grid, segments);
        std::reverse(backward.begin(), backward.end());
        EXPECT_EQ(forward, backward) << row.grid.name;
    }
}

TEST_P(HardGridsOnDevice, NumbersThatAreNotFiniteStayWhatTheyAreAndHurtNobody)
{
    const TestGrid grid = plain_grid("noise", {4, 3, 5}, noise(222));
    const auto good = segment<float>(grid, {.2, .3, .4}, {3.9, 2.7, 4.8});
    std::vector<std::array<float, 6>> segments;
    for (std::size_t i = 0; i < 6; ++i)
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -3e38f}) {
            segments.push_back(good);
            segments.push_back(good);
            segments.back()[i] = bad;
        }
    const auto out = evaluator()(grid, segments);
    for (std::size_t i = 0; i < segments.size(); i += 2) {
        EXPECT_EQ(out[i], out[0]);
        EXPECT_TRUE(!std::isfinite(out[i + 1][0]) || i % 6 == 4) << i;  // -3e38: any number will do
    }
}

}  // namespace
}  // namespace tyndall::test
