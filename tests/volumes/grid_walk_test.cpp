// Grids against their oracle on the host, in float and in double; what a walk consists of; and that the rows find errors.
#include "tests/volumes/check_grid.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "tests/volumes/grid_maths.hpp"
// clang-format on

namespace tyndall::test {
namespace {

template <class Real>
std::vector<std::array<Real, 4>> evaluate_each(const TestGrid& grid, const std::vector<std::array<Real, 6>>& segments)
{
    std::vector<std::array<Real, 4>> out;
    for (const auto& s : segments) out.push_back(evaluate_on_host<Real>(grid.record, grid.voxels, grid.channels, s));
    return out;
}

template <class Real>
class HardGrids : public testing::Test {};
using Precisions = testing::Types<float, double>;
struct PrecisionNames {
    template <class Real>
    static std::string GetName(int) { return sizeof(Real) == 4 ? "float" : "double"; }
};
TYPED_TEST_SUITE(HardGrids, Precisions, PrecisionNames);

TYPED_TEST(HardGrids, Row19EmptyVoxelsGiveZeroAndNothingElse) { check_grids<TypeParam>(row19<TypeParam>(), evaluate_each<TypeParam>); }
TYPED_TEST(HardGrids, Row20FacesEdgesCornersAndAxisParallelWays) { check_grids<TypeParam>(row20<TypeParam>(), evaluate_each<TypeParam>); }
TYPED_TEST(HardGrids, Row21TrilinearValuesAreIntegratedExactly) { check_grids<TypeParam>(row21<TypeParam>(), evaluate_each<TypeParam>); }

/// Between the outermost centre of an empty voxel and its face nothing may remain, not even a rounding.
TYPED_TEST(HardGrids, Row19TheEmptyHalfOfTwoVoxelsIsExactlyEmpty)
{
    const TestGrid grid = plain_grid("0 1 along x", {2, 1, 1}, [](std::size_t i) { return float(i); });
    GridRandom random(193);
    for (int i = 0; i < 1000; ++i) {
        const auto s = segment<TypeParam>(grid, {random.uniform(-1, .4), random.uniform(-1, 2), random.uniform(-1, 2)}, {random.uniform(-1, .4), random.uniform(-1, 2), random.uniform(-1, 2)});
        EXPECT_EQ(evaluate_each<TypeParam>(grid, {s})[0][0], 0) << describe(grid, s);
    }
}

/// There and back: positions are rounded from either end, so the two depths differ by no more than the tolerances of both.
TYPED_TEST(HardGrids, Row20ReversedSegmentsHaveTheSameDepth)
{
    for (const auto& rows : {row19<TypeParam>(), row20<TypeParam>(), row21<TypeParam>()})
        for (const GridRow<TypeParam>& row : rows) {
            const GridOracle oracle(row.grid.record, row.grid.voxels);
            for (const auto& s : row.segments) {
                const std::array<TypeParam, 6> back{s[3], s[4], s[5], s[0], s[1], s[2]};
                const auto there = oracle.along(s, Big(std::numeric_limits<TypeParam>::epsilon())), again = oracle.along(back, Big(std::numeric_limits<TypeParam>::epsilon()));
                if (there.on_the_edge || again.on_the_edge) continue;
                const auto depths = evaluate_each<TypeParam>(row.grid, {s, back});
                EXPECT_TRUE(within(depths[0][0], Big(depths[1][0]), there.depth_tolerance + again.depth_tolerance)) << describe(row.grid, s) << depths[0][0] << " " << depths[1][0];
            }
        }
}

/// What is not a number stays one, and reads nothing outside of the table.
TYPED_TEST(HardGrids, NumbersThatAreNotFiniteStayWhatTheyAre)
{
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN(), infinity = std::numeric_limits<TypeParam>::infinity();
    for (const TestGrid& grid : {plain_grid("noise", {4, 3, 5}, noise(222)), plain_grid("one voxel", {1, 1, 1}, noise(223)), plain_grid("empty", {2, 2, 2}, [](std::size_t) { return 0.f; })})
        for (std::size_t i = 0; i < 6; ++i) {
            std::array<TypeParam, 6> s = segment<TypeParam>(grid, {.2, .3, .4}, {.9, .7, .8});
            s[i] = nan;
            const auto out = evaluate_each<TypeParam>(grid, {s})[0];
            EXPECT_TRUE(std::isnan(out[0])) << "coordinate " << i;
            EXPECT_TRUE(i >= 3 || (std::isnan(out[1]) && std::isnan(out[2])));
            s[i] = infinity;
            EXPECT_FALSE(std::isfinite(evaluate_each<TypeParam>(grid, {s})[0][0]));
            for (const TypeParam huge : {TypeParam(1e9), TypeParam(-1e15), TypeParam(1e18)}) {  // far away is finite
                s[i] = huge;
                const auto far = evaluate_each<TypeParam>(grid, {s})[0];
                EXPECT_TRUE(std::isfinite(far[0]) && std::isfinite(far[1])) << describe(grid, s);
                EXPECT_GE(far[0], 0);
            }
        }
}

/// 36 cells with a depth of a few, the segments that a renderer has: 1e-6 in float.
TEST(GridWalk, OrdinarySegmentsAreRightToOneInAMillion)
{
    GridRow<float> row{placed_grid("cloud", {20, 20, 20}, {-.5, -.45, -.55}, {{{.05, 0, 0}, {0, .045, 0}, {0, 0, .055}}}, noise(231)), {}};
    GridRandom random(232);
    double worst = 0;
    const GridOracle oracle(row.grid.record, row.grid.voxels);
    for (int i = 0; i < 60; ++i) {
        const auto s = segment<float>(row.grid, random.point(0, 20), random.point(0, 20));
        const auto expected = oracle.along(s, Big(std::numeric_limits<float>::epsilon()));
        worst = std::max(worst, std::abs(double(evaluate_each<float>(row.grid, {s})[0][0] / expected.depth - 1)));
    }
    EXPECT_LT(worst, 1e-6);
    RecordProperty("worst_relative_error", std::to_string(worst));
}

/// The pieces of a walk touch, lie in the box, are no more than promised, and their parts add up.
TEST(GridWalk, PiecesTouchAndAddUp)
{
    for (const auto& rows : {row19<double>(), row20<double>(), row21<double>()})
        for (const GridRow<double>& row : rows)
            for (const auto& s : row.segments) {
                const GridRecord& g = row.grid.record;
                maths_double::GridWalk w = maths_double::begin_grid_walk(g, {s[0], s[1], s[2]}, {s[3], s[4], s[5]});
                unsigned pieces = 0;
                for (; maths_double::walks_grid(w) && pieces <= maths_double::most_grid_pieces(g); w = maths_double::next_cell(w), ++pieces) {
                    const double t0 = w.t, t1 = maths_double::piece_end(w), middle = t0 + .3 * (t1 - t0);
                    ASSERT_LE(t0, t1);
                    ASSERT_TRUE(0 <= t0 && t1 <= 1);
                    const maths_double::GridCell cell = maths_double::load_cell(g, row.grid.voxels.data(), w.cell);
                    const double whole = maths_double::walk_integral(w, cell, t0, t1);
                    ASSERT_GE(whole, 0);
                    ASSERT_NEAR(maths_double::walk_integral(w, cell, t0, middle) + maths_double::walk_integral(w, cell, middle, t1), whole, 1e-13 * (whole + (t1 - t0)));
                }
                ASSERT_LT(pieces, maths_double::most_grid_pieces(g)) << describe(row.grid, s);
            }
}

// The rows find errors.

/// Share of the segments that pass through something whose depth `wrong` misses.
template <class F>
double share_missed(const std::vector<GridRow<double>>& rows, F&& wrong)
{
    const Missed missed = check_grids<double>(
        rows,
        [&](const TestGrid& grid, const std::vector<std::array<double, 6>>& segments) {
            auto out = evaluate_each<double>(grid, segments);
            for (std::size_t i = 0; i < out.size(); ++i) out[i][0] = wrong(grid, segments[i], out[i][0]);
            return out;
        },
        false);
    return double(missed.depths) / double(missed.through);
}

TEST(HardGridsFind, OnePointPerCell)
{
    const auto midpoints = [](const TestGrid& grid, const std::array<double, 6>& s, double) {
        maths_double::GridWalk w = maths_double::begin_grid_walk(grid.record, {s[0], s[1], s[2]}, {s[3], s[4], s[5]});
        double sum = 0;
        for (; maths_double::walks_grid(w); w = maths_double::next_cell(w)) {
            const double t1 = maths_double::piece_end(w);
            sum += (t1 - w.t) * maths_double::walk_value(w, maths_double::load_cell(grid.record, grid.voxels.data(), w.cell), .5 * (w.t + t1));
        }
        return sum * std::sqrt((s[3] - s[0]) * (s[3] - s[0]) + (s[4] - s[1]) * (s[4] - s[1]) + (s[5] - s[2]) * (s[5] - s[2]));
    };
    EXPECT_GT(share_missed(row21<double>(), midpoints), .8);
}

TEST(HardGridsFind, AnErrorOfAFewRoundings)
{
    EXPECT_GT(share_missed(row21<double>(), [](const TestGrid&, const auto&, double depth) { return depth * (1 + 1e-12); }), .7);
    EXPECT_GT(share_missed(row20<double>(), [](const TestGrid&, const auto&, double depth) { return depth * (1 + 1e-12); }), .7);
}

/// Half a voxel off.
TEST(HardGridsFind, ValuesAtCornersInsteadOfCentres)
{
    const auto shifted = [](const TestGrid& grid, const std::array<double, 6>& s, double) {
        GridRecord moved = grid.record;
        moved.x_0 -= .5f, moved.y_0 -= .5f, moved.z_0 -= .5f;
        return evaluate_on_host<double>(moved, grid.voxels, 1, s)[0];
    };
    EXPECT_GT(share_missed(row21<double>(), shifted), .9);
}

}  // namespace
}  // namespace tyndall::test
