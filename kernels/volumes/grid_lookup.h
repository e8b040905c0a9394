/// Values of density grids at points, for the stages: fast, and inside the table whatever the coordinates (kernels/README.md, section 13).
#ifndef GRID_LOOKUP_H
#define GRID_LOOKUP_H

#include "kernels/volumes/grid_walk.h"

/// What lookups need of a grid, the same for all lanes: the last voxel along each axis, the last that has one ahead, and how far apart neighbours lie in the
/// table (0 along an axis of one voxel).
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

/// x in [0, last]; what is not a number becomes 0. Comparisons in place of fmin and fmax, which cost three instructions each.
PURE real between(real x, real last)
{
    x = select(R(0.0), x, x > R(0.0));
    return select(last, x, x < last);
}

/// The voxel that holds voxel coordinates, which are moved into the box along its axes.
PURE real voxel_at(GridLookup l, __global const float* first, real3 at)
{
    bits i = to_bits(between(at.x, l.last_x)), j = to_bits(between(at.y, l.last_y)), k = to_bits(between(at.z, l.last_z));
    return gather_lanes(first, k * l.layer + j * l.row + i);
}

/// The trilinear value at voxel coordinates, which are moved into the box along its axes. One number serves all corners.
PURE real value_at(GridLookup l, __global const float* first, real3 at)
{
    real x = between(at.x - R(0.5), l.last_x), y = between(at.y - R(0.5), l.last_y), z = between(at.z - R(0.5), l.last_z);
    real i = between(to_real(to_whole(x)), l.lowest_x), j = between(to_real(to_whole(y)), l.lowest_y), k = between(to_real(to_whole(z)), l.lowest_z);
    bits corner = to_bits(k) * l.layer + to_bits(j) * l.row + to_bits(i);
    __global const float *ahead = first + l.step_x, *above = first + l.step_z, *above_ahead = above + l.step_x;
    GridCell c;
    c.v000 = gather_lanes(first, corner), c.v100 = gather_lanes(ahead, corner);
    c.v010 = gather_lanes(first + l.step_y, corner), c.v110 = gather_lanes(ahead + l.step_y, corner);
    c.v001 = gather_lanes(above, corner), c.v101 = gather_lanes(above_ahead, corner);
    c.v011 = gather_lanes(above + l.step_y, corner), c.v111 = gather_lanes(above_ahead + l.step_y, corner);
    return value_in_cell(c, x - i, y - j, z - k);
}

/// Do voxel coordinates lie outside of the box?
PURE mask beyond_box(GridRecord grid, real3 at)
{
    real low = fmin(at.x, fmin(at.y, at.z));
    real high = fmax(at.x - (real)(float)grid.size_x, fmax(at.y - (real)(float)grid.size_y, at.z - (real)(float)grid.size_z));
    return (low < R(0.0)) | (high > R(0.0));
}

#endif
