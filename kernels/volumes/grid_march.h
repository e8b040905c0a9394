/// Integrals of density grids along segments by a march with random shifts: the fast estimate beside the exact walk (kernels/README.md, section 13).
#ifndef GRID_MARCH_H
#define GRID_MARCH_H

#include "kernels/volumes/grid_lookup.h"

/// Steps are at most so many voxels long along every axis, and there are at least so many of them.
#define MARCH_STRIDE R(8.0)
#define MARCH_FEWEST 8
#define MARCH_LEAST ((real)(float)MARCH_FEWEST)
/// More are never taken: a segment inside the box crosses no more voxels than the box has along an axis. Stops coordinates that are not numbers.
#define MARCH_MOST R(4096.0)

/// How a march is shifted: along itself in steps, in (0, 1); aside in voxels, in (-1/2, 1/2).
typedef struct { real along, x, y, z; } MarchShift;

/// From 32 random bits, 8 for each: the middles of 256 equal intervals.
PURE MarchShift march_shift(bits random)
{
    MarchShift s;
    s.along = fma(to_real(random >> 24), R(0x1p-8), R(0x1p-9));
    s.x = fma(to_real(random >> 16 & 255u), R(0x1p-8), R(0x1p-9) - R(0.5));
    s.y = fma(to_real(random >> 8 & 255u), R(0x1p-8), R(0x1p-9) - R(0.5));
    s.z = fma(to_real(random & 255u), R(0x1p-8), R(0x1p-9) - R(0.5));
    return s;
}

/// The part of a segment from + t d, enter <= t <= leave, that lies inside the box of a grid, in voxel coordinates, and the steps of a march along it.
typedef struct {
    real3 start, step;
    real3 aside;        ///< shift of steps of even number; the others are shifted the opposite way
    real steps, share;  ///< how many; part of the whole segment that one of them is
} GridMarch;

PURE GridMarch begin_grid_march(GridRecord grid, real3 from, real3 d, real enter, real leave, MarchShift shift)
{
    real3 start = to_grid(grid, from), way = direction_to_grid(grid, d);
    ClipInterval inside = {enter, leave};
    real3 first = along3(start, enter, way), last = along3(start, leave, way);
    if (any_lane(beyond_box(grid, first) | beyond_box(grid, last))) {
        inside = clip_slab(inside, start.x, way.x, grid.size_x);
        inside = clip_slab(inside, start.y, way.y, grid.size_y);
        inside = clip_slab(inside, start.z, way.z, grid.size_z);
        first = along3(start, inside.enter, way);
    }
    real part = fmax(inside.leave - inside.enter, R(0.0));
    GridMarch m;
    m.steps = fmin(fmax(ceil(largest3(way) * part / MARCH_STRIDE), MARCH_LEAST), MARCH_MOST);
    m.share = part / m.steps;
    m.step = make_real3(way.x * m.share, way.y * m.share, way.z * m.share);
    m.start = along3(first, shift.along, m.step), m.aside = make_real3(shift.x, shift.y, shift.z);
    return m;
}

/// Sum of one channel's values met, times the share of a step. Its mean over shifts is the mean of the value over the whole segment where all of it lies in the
/// box: a voxel at a place that is shifted evenly by up to half a voxel along each axis has the trilinear value there for its mean.
PURE real march_voxels(GridLookup l, __global const float* first, GridMarch m)
{
    real sum = R(0.0);
    real3 even = add3(m.start, m.aside), odd = sub3(m.start, m.aside);
    bool more = any_lane(m.steps > MARCH_LEAST);
    for (uint i = 0; i < (uint)MARCH_FEWEST || (more && any_lane((real)(float)i < m.steps)); ++i) {
        real value = voxel_at(l, first, along3(i % 2u == 0u ? even : odd, (real)(float)i, m.step));
        sum += select(R(0.0), value, (real)(float)i < m.steps);
    }
    return sum * m.share;
}

/// The same with trilinear values.
PURE real march_values(GridLookup l, __global const float* first, GridMarch m)
{
    real sum = R(0.0);
    for (uint i = 0; any_lane((real)(float)i < m.steps); ++i)
        sum += select(R(0.0), value_at(l, first, along3(m.start, (real)(float)i, m.step)), (real)(float)i < m.steps);
    return sum * m.share;
}

/// Where the box has no more voxels than this along any axis, a step is so short that single voxels would be noisier than the march: values instead.
#define MARCH_COARSE 16u
PURE uint is_coarse(GridRecord grid) { return grid.size_x <= MARCH_COARSE && grid.size_y <= MARCH_COARSE && grid.size_z <= MARCH_COARSE ? 1u : 0u; }

#endif
