#pragma once
/// Runs rows of grids through something that evaluates segments, and says which one missed what.
#include <gtest/gtest.h>

#include "tests/volumes/grid_cases.hpp"

namespace tyndall::test {

/// depth, value at the beginning, the same moved into the box, depth of the last channel; one for each segment.
template <class Real>
using GridEvaluator = std::function<std::vector<std::array<Real, 4>>(const TestGrid&, const std::vector<std::array<Real, 6>>&)>;

struct Missed {
    std::size_t depths = 0, values = 0, all = 0, through = 0;  ///< through: segments whose depth is not 0
};

template <class Real>
std::string describe(const TestGrid& grid, const std::array<Real, 6>& s)
{
    std::ostringstream text;
    text.precision(std::numeric_limits<Real>::max_digits10);
    text << grid.name << ", from (" << s[0] << ", " << s[1] << ", " << s[2] << ") to (" << s[3] << ", " << s[4] << ", " << s[5] << ")";
    return text.str();
}

/// NaN is not within.
inline bool within(double x, const Big& expected, const Big& tolerance) { return std::isfinite(x) && abs(Big(x) - expected) <= tolerance; }

/// Counts misses; says the first ones if `loud`.
template <class Real>
Missed check_grids(const std::vector<GridRow<Real>>& rows, const GridEvaluator<Real>& evaluate, bool loud = true)
{
    const Big epsilon = Big(std::numeric_limits<Real>::epsilon());
    Missed missed;
    for (const GridRow<Real>& row : rows) {
        const auto out = evaluate(row.grid, row.segments);
        const GridOracle first(row.grid.record, row.grid.voxels, 0), last(row.grid.record, row.grid.voxels, row.grid.channels - 1);
        for (std::size_t i = 0; i < row.segments.size(); ++i) {
            const auto a = first.along(row.segments[i], epsilon), b = last.along(row.segments[i], epsilon);
            const bool depth = a.on_the_edge ? std::isfinite(out[i][0]) : within(out[i][0], a.depth, a.depth_tolerance) && within(out[i][3], b.depth, b.depth_tolerance);
            const bool value = within(out[i][2], a.clamped, a.value_tolerance) && (a.on_the_edge || within(out[i][1], a.value, a.value_tolerance));
            missed.depths += !depth, missed.values += !value, ++missed.all, missed.through += a.depth > 0;
            if (loud && !(depth && value) && missed.depths + missed.values <= 10)
                ADD_FAILURE() << describe(row.grid, row.segments[i]) << ": depth " << out[i][0] << ", " << out[i][3] << " instead of " << a.depth << ", " << b.depth << " +- "
                              << a.depth_tolerance << "; value " << out[i][1] << ", clamped " << out[i][2] << " instead of " << a.value << ", " << a.clamped << " +- "
                              << a.value_tolerance;
        }
    }
    EXPECT_TRUE(!loud || missed.depths + missed.values == 0) << missed.depths << " depths and " << missed.values << " values of " << missed.all << " segments";
    return missed;
}

}  // namespace tyndall::test
