/// Integrals of density grids along segments by a march with a random offset: the fast estimate beside the exact walk (kernels/README.md, section 13).
#ifndef GRID_MARCH_H
#define GRID_MARCH_H

#include "kernels/volumes/grid_walk.h"

/// Steps are at most so many voxels long along every axis, and there are at least so many of them.
#define MARCH_STRIDE R(8.0)
#define MARCH_LEAST R(8.0)
/// More are never taken: a segment inside the box crosses no more voxels than the box has along an axis. Stops coordinates that are not numbers.
#define MARCH_MOST R(4096.0)

/// What a lookup needs of a grid, the same for all lanes: the last cell between two centres along each axis, and how far apart its corners lie in the table.
typedef struct {
    real last_x, last_y, last_z, lowest_x, lowest_y, lowest_z;
    uint step_x, step_y, step_z, row, layer;
} GridLookup;

PURE GridLookup grid_lookup(GridRecord grid)
{
    GridLookup l;
    l.last_x = (real)(float)(grid.size_x - 1u), l.last_y = (real)(float)(grid.size_y - 1u), l.last_z = (real)(float)(grid.size_z - 1u);
    l.lowest_x = fmax(l.last_x - R(1.0), R(0.0)), l.lowest_y = fmax(l.last_y - R(1.0), R(0.0)), l.lowest_z = fmax(l.last_z - R(1.0), R(0.0));
    l.row = grid.size_x, l.layer = grid.size_x * grid.size_y;
    l.step_x = grid.size_x > 1u ? 1u : 0u, l.step_y = grid.size_y > 1u ? l.row : 0u, l.step_z = grid.size_z > 1u ? l.layer : 0u;
    return l;
}

/// Value at voxel coordinates, moved into the box along its axes. Every index is inside the table whatever the coordinates; one index serves all eight corners.
PURE real look_up(GridLookup l, __global const float* first, real3 at)
{
    real x = fmin(fmax(at.x - R(0.5), R(0.0)), l.last_x), y = fmin(fmax(at.y - R(0.5), R(0.0)), l.last_y), z = fmin(fmax(at.z - R(0.5), R(0.0)), l.last_z);
    real i = fmin(floor(x), l.lowest_x), j = fmin(floor(y), l.lowest_y), k = fmin(floor(z), l.lowest_z);
    bits corner = to_bits(k) * l.layer + to_bits(j) * l.row + to_bits(i);
    x -= i, y -= j, z -= k;
    __global const float *y1 = first + l.step_y, *z1 = first + l.step_z, *yz1 = y1 + l.step_z;
    real v00 = gather_lanes(first, corner), v10 = gather_lanes(y1, corner), v01 = gather_lanes(z1, corner), v11 = gather_lanes(yz1, corner);
    v00 = fma(x, gather_lanes(first + l.step_x, corner) - v00, v00), v10 = fma(x, gather_lanes(y1 + l.step_x, corner) - v10, v10);
    v01 = fma(x, gather_lanes(z1 + l.step_x, corner) - v01, v01), v11 = fma(x, gather_lanes(yz1 + l.step_x, corner) - v11, v11);
    real v0 = fma(y, v10 - v00, v00), v1 = fma(y, v11 - v01, v01);
    return fma(z, v1 - v0, v0);
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
    inside = clip_slab(inside, start.x, way.x, grid.size_x);
    inside = clip_slab(inside, start.y, way.y, grid.size_y);
    inside = clip_slab(inside, start.z, way.z, grid.size_z);
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
PURE real3 march_grid(GridRecord grid, __global const float* voxels, GridMarch m, uint channels)
{
    GridLookup l = grid_lookup(grid);
    __global const float* first = voxels + grid.first;
    uint block = l.layer * grid.size_z;
    real3 sum = make_real3(R(0.0), R(0.0), R(0.0));
    for (real i = R(0.0); any_lane(i < m.steps); i += R(1.0)) {
        mask on = i < m.steps;
        real3 at = along3(m.start, i, m.step);
        sum.x += select(R(0.0), look_up(l, first, at), on);
        if (channels == 1u) continue;
        sum.y += select(R(0.0), look_up(l, first + block, at), on);
        sum.z += select(R(0.0), look_up(l, first + 2u * block, at), on);
    }
    if (channels == 1u) sum.y = sum.z = sum.x;
    return make_real3(sum.x * m.share, sum.y * m.share, sum.z * m.share);
}

#endif
