// Lookups and marches, the fast estimates of kernels/volumes, on the host in float and in double: values against the oracle's, means over shifts against the
// exact integrals of the walk, which has an oracle of its own.
#include "tests/volumes/check_grid.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "tests/volumes/grid_maths.hpp"
// clang-format on

namespace tyndall::maths_float {
#include "kernels/volumes/grid_march.h"
}
#undef GRID_MARCH_H
#undef GRID_LOOKUP_H
namespace tyndall::maths_double {
#include "kernels/volumes/grid_march.h"
}

namespace tyndall::test {
namespace {

/// What both precisions have under the same names.
struct InFloat {
    using Real = float;
    static float value(const TestGrid& g, float x, float y, float z) { return maths_float::value_at(maths_float::grid_lookup(g.record), g.voxels.data() + 3, {x, y, z}); }
    static float voxel(const TestGrid& g, float x, float y, float z) { return maths_float::voxel_at(maths_float::grid_lookup(g.record), g.voxels.data() + 3, {x, y, z}); }
    static float march(const TestGrid& g, const std::array<float, 6>& s, unsigned random, bool voxels)
    {
        const auto m = maths_float::begin_grid_march(g.record, {s[0], s[1], s[2]}, {s[3] - s[0], s[4] - s[1], s[5] - s[2]}, 0, 1, maths_float::march_shift(random));
        const auto l = maths_float::grid_lookup(g.record);
        return voxels ? maths_float::march_voxels(l, g.voxels.data() + 3, m) : maths_float::march_values(l, g.voxels.data() + 3, m);
    }
};
struct InDouble {
    using Real = double;
    static double value(const TestGrid& g, double x, double y, double z) { return maths_double::value_at(maths_double::grid_lookup(g.record), g.voxels.data() + 3, {x, y, z}); }
    static double voxel(const TestGrid& g, double x, double y, double z) { return maths_double::voxel_at(maths_double::grid_lookup(g.record), g.voxels.data() + 3, {x, y, z}); }
    static double march(const TestGrid& g, const std::array<double, 6>& s, unsigned random, bool voxels)
    {
        const auto m = maths_double::begin_grid_march(g.record, {s[0], s[1], s[2]}, {s[3] - s[0], s[4] - s[1], s[5] - s[2]}, 0, 1, maths_double::march_shift(random));
        const auto l = maths_double::grid_lookup(g.record);
        return voxels ? maths_double::march_voxels(l, g.voxels.data() + 3, m) : maths_double::march_values(l, g.voxels.data() + 3, m);
    }
};

template <class Precision>
class GridMarches : public testing::Test {
public:
    using Real = typename Precision::Real;
    using Row = GridRow<Real>;
    static std::vector<Row> all_rows()
    {
        std::vector<Row> rows;
        for (auto& some : {row19<Real>(), row20<Real>(), row21<Real>()}) rows.insert(rows.end(), some.begin(), some.end());
        return rows;
    }
};
struct PrecisionNames {
    template <class Precision>
    static std::string GetName(int) { return sizeof(typename Precision::Real) == 4 ? "float" : "double"; }
};
using Precisions = testing::Types<InFloat, InDouble>;
TYPED_TEST_SUITE(GridMarches, Precisions, PrecisionNames);

/// Moved into the box or not, on faces, in boxes of one voxel: the oracle's value, to its tolerance and one rounding of the product form.
TYPED_TEST(GridMarches, AValueIsTheTrilinearOne)
{
    using Real = typename TypeParam::Real;
    const Big epsilon = Big(std::numeric_limits<Real>::epsilon());
    for (const auto& row : TestFixture::all_rows()) {
        const GridOracle oracle(row.grid.record, row.grid.voxels, 0);
        const GridRecord& r = row.grid.record;
        for (const auto& s : row.segments) {
            const auto a = oracle.along(s, epsilon);
            const auto at = [&](const float* m) { return Real(m[0]) * s[0] + (Real(m[1]) * s[1] + (Real(m[2]) * s[2] + Real(m[3]))); };
            EXPECT_TRUE(within(TypeParam::value(row.grid, at(&r.x_x), at(&r.y_x), at(&r.z_x)), a.clamped, 2 * a.value_tolerance)) << describe(row.grid, s);
        }
    }
}

/// Mean of the voxel over 8 x 8 x 8 shifts, at places whose fractions are eighths: the shares of the neighbours are exact, so the mean is the value.
template <class Precision>
double mean_of_voxels(const TestGrid& grid, const Point& p, double reach)
{
    double sum = 0;
    for (int i = 0; i < 512; ++i) {
        const auto off = [&](int k) { return reach * ((k + .5) / 8 - .5); };
        sum += double(Precision::voxel(grid, typename Precision::Real(p[0] + off(i % 8)), typename Precision::Real(p[1] + off(i / 8 % 8)), typename Precision::Real(p[2] + off(i / 64)))) / 512;
    }
    return sum;
}

TYPED_TEST(GridMarches, AVoxelAtAShiftedPlaceHasTheValueForItsMean)
{
    using Real = typename TypeParam::Real;
    GridRandom random(261);
    double unshifted = 0;
    for (const TestGrid& grid : {plain_grid("noise", {6, 5, 4}, noise(262)), plain_grid("sheet", {5, 1, 4}, noise(263)), plain_grid("one voxel", {1, 1, 1}, noise(264))})
        for (int i = 0; i < 200; ++i) {
            Point p;
            const unsigned size[] = {grid.record.size_x, grid.record.size_y, grid.record.size_z};
            for (std::size_t k = 0; k < 3; ++k) p[k] = std::floor(random.uniform(0, size[k] + 1e-9) * 8) / 8;
            const double value = TypeParam::value(grid, Real(p[0]), Real(p[1]), Real(p[2]));
            EXPECT_NEAR(mean_of_voxels<TypeParam>(grid, p, 1), value, 8 * std::numeric_limits<Real>::epsilon() * value) << grid.name << " at " << p[0] << " " << p[1] << " " << p[2];
            unshifted = std::max(unshifted, std::abs(mean_of_voxels<TypeParam>(grid, p, 0) - value));
        }
    EXPECT_GT(unshifted, .5) << "without shifts it is not";
}

/// Mean over shifts: the integral over the segment, to 5 standard errors and what 256 places per step in place of all can change.
TYPED_TEST(GridMarches, TheMeanIsTheIntegral)
{
    constexpr int shifts = 2000;
    double worst_z = 0;
    for (const bool voxels : {true, false})
        for (const auto& row : TestFixture::all_rows())
            for (std::size_t i = 0; i < row.segments.size(); i += 17) {
                const auto& s = row.segments[i];
                const double length = std::hypot(double(s[3]) - double(s[0]), double(s[4]) - double(s[1]), double(s[5]) - double(s[2]));
                const double exact = double(evaluate_on_host<typename TypeParam::Real>(row.grid.record, row.grid.voxels, 1, s)[0]) / std::max(length, 1e-30);
                GridRandom random(271 + unsigned(i));
                double sum = 0, squares = 0;
                for (int k = 0; k < shifts; ++k) {
                    const double x = double(TypeParam::march(row.grid, s, unsigned(random.engine() >> 32), voxels));
                    sum += x / shifts, squares += x * x / shifts;
                }
                if (length == 0) continue;
                const double error = std::sqrt(std::max(squares - sum * sum, 0.) / shifts);
                EXPECT_NEAR(sum, exact, 5 * error + 3. / 512 / 8) << describe(row.grid, s) << (voxels ? ", voxels" : ", values");
                if (error > 1e-3) worst_z = std::max(worst_z, std::abs(sum - exact) / error);
            }
    EXPECT_GT(worst_z, 1) << "errors are not overstated";
}

/// Every number of a voxel is inside the table.
TYPED_TEST(GridMarches, NumbersThatAreNotFiniteReadInside)
{
    using Real = typename TypeParam::Real;
    const TestGrid grid = plain_grid("noise", {4, 3, 5}, noise(281));
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity(), Real(1e30), Real(-1e30)})
        for (int k = 0; k < 3; ++k) {
            Real p[3] = {1, 1, 1};
            p[k] = bad;
            EXPECT_LE(TypeParam::voxel(grid, p[0], p[1], p[2]), 3);  // what lies before the grid is 1e30
            EXPECT_LE(TypeParam::value(grid, p[0], p[1], p[2]), 3);
            std::array<Real, 6> s = segment<Real>(grid, {.2, .3, .4}, {3.9, 2.7, 4.8});
            s[std::size_t(k)] = bad;
            const double march = double(TypeParam::march(grid, s, 12345u, true));
            EXPECT_TRUE(!(march > 3)) << march;
        }
}

}  // namespace
}  // namespace tyndall::test
