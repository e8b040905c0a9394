/// Integrals of density grids along segments by a march with a random offset: the fast estimate beside the exact walk (kernels/README.md, section 13).
#ifndef GRID_MARCH_H
#define GRID_MARCH_H

#include "kernels/volumes/grid_walk.h"

/// Steps are at most so many voxels long along every axis, and there are at least so many of them.
#define MARCH_STRIDE R(8.0)
#define MARCH_FEWEST 8
#define MARCH_LEAST ((real)(float)MARCH_FEWEST)
/// More are never taken: a segment inside the box crosses no more voxels than the box has along an axis. Stops coordinates that are not numbers.
#define MARCH_MOST R(4096.0)

/// What a lookup needs of a grid, the same for all lanes: the last cell between two centres along each axis, and how far apart its corners lie in the table.
typedef struct {
    real last_x, last_y, last_z, lowest_x, lowest_y, lowest_z;
    uint step_y, step_z, row, layer;
} GridLookup;

PURE GridLookup grid_lookup(GridRecord grid)
{
    GridLookup l;
    l.last_x = (real)(float)(grid.size_x - 1u), l.last_y = (real)(float)(grid.size_y - 1u), l.last_z = (real)(float)(grid.size_z - 1u);
    l.lowest_x = fmax(l.last_x - R(1.0), R(0.0)), l.lowest_y = fmax(l.last_y - R(1.0), R(0.0)), l.lowest_z = fmax(l.last_z - R(1.0), R(0.0));
    l.row = grid.size_x, l.layer = grid.size_x * grid.size_y;
    l.step_y = grid.size_y > 1u ? l.row : 0u, l.step_z = grid.size_z > 1u ? l.layer : 0u;
    return l;
}

/// x in [0, last]; what is not a number becomes 0. Comparisons in place of fmin and fmax, which cost three instructions each.
PURE real between(real x, real last)
{
    x = select(R(0.0), x, x > R(0.0));
    return select(last, x, x < last);
}

/// Nearly the value at voxel coordinates, moved into the box along its axes, from packed voxels: a word holds a voxel and its neighbour ahead in x, each
/// rounded to the upper half of a float, 2^-9 of itself. Every index is inside the table whatever the coordinates, and one index serves all corners.
PURE real look_up(GridLookup l, __global const uint* first, real3 at)
{
    real x = between(at.x - R(0.5), l.last_x), y = between(at.y - R(0.5), l.last_y), z = between(at.z - R(0.5), l.last_z);
    real i = between(to_real(to_whole(x)), l.lowest_x), j = between(to_real(to_whole(y)), l.lowest_y), k = between(to_real(to_whole(z)), l.lowest_z);
    bits corner = to_bits(k) * l.layer + to_bits(j) * l.row + to_bits(i);
    x -= i, y -= j, z -= k;
    bits w00 = gather_bits(first, corner), w10 = gather_bits(first + l.step_y, corner);
    bits w01 = gather_bits(first + l.step_z, corner), w11 = gather_bits(first + l.step_y + l.step_z, corner);
    real v00 = fma(x, upper_half(w00) - lower_half(w00), lower_half(w00)), v10 = fma(x, upper_half(w10) - lower_half(w10), lower_half(w10));
    real v01 = fma(x, upper_half(w01) - lower_half(w01), lower_half(w01)), v11 = fma(x, upper_half(w11) - lower_half(w11), lower_half(w11));
    real v0 = fma(y, v10 - v00, v00), v1 = fma(y, v11 - v01, v01);
    return fma(z, v1 - v0, v0);
}

/// Do voxel coordinates lie outside of the box?
PURE mask beyond_box(GridRecord grid, real3 at)
{
    real low = fmin(at.x, fmin(at.y, at.z));
    real high = fmax(at.x - (real)(float)grid.size_x, fmax(at.y - (real)(float)grid.size_y, at.z - (real)(float)grid.size_z));
    return (low < R(0.0)) | (high > R(0.0));
}

/// The part of a segment from + t d, enter <= t <= leave, that lies inside the box of a grid, in voxel coordinates, and the steps of a march along it.
typedef struct {
    real3 start, step;
    real steps, share;  ///< how many; part of the whole segment that one of them is
} GridMarch;

PURE GridMarch begin_grid_march(GridRecord grid, real3 from, real3 d, real enter, real leave, real jitter)
{
    real3 start = to_grid(grid, from), way = direction_to_grid(grid, d);
    ClipInterval inside = {enter, leave};
    real3 first = along3(start, enter, way), last = along3(start, leave, way);
    if (any_lane(beyond_box(grid, first) | beyond_box(grid, last))) {
        inside = clip_slab(inside, start.x, way.x, grid.size_x);
        inside = clip_slab(inside, start.y, way.y, grid.size_y);
        inside = clip_slab(inside, start.z, way.z, grid.size_z);
    }
    real part = fmax(inside.leave - inside.enter, R(0.0));
    GridMarch m;
    m.steps = fmin(fmax(ceil(largest3(way) * part / MARCH_STRIDE), MARCH_LEAST), MARCH_MOST);
    m.share = part / m.steps;
    m.step = make_real3(way.x * m.share, way.y * m.share, way.z * m.share);
    m.start = along3(along3(start, inside.enter, way), jitter, m.step);
    return m;
}

/// Sum of the values met, times the share of a step: the mean of the value over the whole segment where all of it lies in the box. Its mean over the
/// jitter in [0, 1) is exact. `channels` = 3: those of a grid with three.
PURE real3 march_grid(GridRecord grid, __global const uint* packed, GridMarch m, uint channels)
{
    GridLookup l = grid_lookup(grid);
    __global const uint* first = packed + grid.first;
    uint block = l.layer * grid.size_z;
    real3 sum = make_real3(R(0.0), R(0.0), R(0.0));
    bool more = any_lane(m.steps > MARCH_LEAST);
    for (uint i = 0; i < (uint)MARCH_FEWEST || (more && any_lane((real)(float)i < m.steps)); ++i) {
        mask on = (real)(float)i < m.steps;
        real3 at = along3(m.start, (real)(float)i, m.step);
        sum.x += select(R(0.0), look_up(l, first, at), on);
        if (channels == 1u) continue;
        sum.y += select(R(0.0), look_up(l, first + block, at), on);
        sum.z += select(R(0.0), look_up(l, first + 2u * block, at), on);
    }
    if (channels == 1u) sum.y = sum.z = sum.x;
    return make_real3(sum.x * m.share, sum.y * m.share, sum.z * m.share);
}

#endif
