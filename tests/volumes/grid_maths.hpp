#pragma once
/// kernels/volumes and evaluate_grid.h on the host, in both precisions. Comes after everything that is not the kernels'.
#include <array>
#include <vector>

#include "kernels/shared/records.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall::maths_float {
#include "tests/volumes/evaluate_grid.h"
}
#undef EVALUATE_GRID_H
#undef GRID_WALK_H
#undef CLIP_H
namespace tyndall::maths_double {
#include "tests/volumes/evaluate_grid.h"
}

namespace tyndall::test {

/// depth, value, clamped value, depth of the last channel.
template <class Real>
std::array<Real, 4> evaluate_on_host(const GridRecord& grid, const std::vector<float>& voxels, unsigned channels, const std::array<Real, 6>& s)
{
    if constexpr (sizeof(Real) == 4) {
        const auto o = maths_float::evaluate_grid(grid, voxels.data(), channels, {s[0], s[1], s[2]}, {s[3], s[4], s[5]});
        return {o.depth, o.value, o.clamped, o.last};
    } else {
        const auto o = maths_double::evaluate_grid(grid, voxels.data(), channels, {s[0], s[1], s[2]}, {s[3], s[4], s[5]});
        return {o.depth, o.value, o.clamped, o.last};
    }
}

}  // namespace tyndall::test
