/// Density grids: values at points, and exact integrals along straight segments. The value is trilinear between the centres of voxels, so the segment is cut
/// where it passes a plane of centres; in each piece the value is a cubic of the distance, which two Gauss points integrate exactly (kernels/README.md).
/// Distances along a segment are shares t of it, 0 <= t <= 1. Every index is clamped: numbers that are not finite read inside the table and stay what they are.
/// On the host kernels/shared/records.hpp comes first.
#ifndef GRID_WALK_H
#define GRID_WALK_H

#include "kernels/math/clip.h"
#include "kernels/math/maths.h"
#include "kernels/shared/grid.h"

#define GRID_NEVER R(3e38)   // a t that no segment reaches, in either precision
/// A way shorter than this, in voxels, over the whole segment, is none: nothing in a grid changes along it, and the inverse of a longer one times any
/// voxel coordinate below 1e8 is finite.
#define GRID_STILL R(1e-30)

/// A segment on its way through the cells between the centres of voxels. Along each axis cell i lies between the centres of the voxels i - 1 and i, where the
/// first (0) and the last one (size) are the outermost half voxels: their two centres are the same one, so that nothing changes along the axis.
typedef struct {
    real3 start, way;  ///< voxel coordinates of its beginning; way to its end
    real3 inverse;     ///< 1 / way; of no use where nothing moves
    real3 cell;        ///< whole numbers
    real3 leaves;      ///< t at which it leaves the cell along each axis
    real t, end;       ///< where in the cell it is; where it leaves the box. t >= end: there is no more
} GridWalk;

/// Values at the corners of a cell: v<x><y><z>.
typedef struct { real v000, v100, v010, v110, v001, v101, v011, v111; } GridCell;

/// Voxel coordinates of a point of render space, and of a direction.
PURE real3 to_grid(GridRecord grid, real3 p)
{
    return make_real3(fma((real)grid.x_x, p.x, fma((real)grid.x_y, p.y, fma((real)grid.x_z, p.z, (real)grid.x_0))),
                      fma((real)grid.y_x, p.x, fma((real)grid.y_y, p.y, fma((real)grid.y_z, p.z, (real)grid.y_0))),
                      fma((real)grid.z_x, p.x, fma((real)grid.z_y, p.y, fma((real)grid.z_z, p.z, (real)grid.z_0))));
}
PURE real3 direction_to_grid(GridRecord grid, real3 d)
{
    return make_real3(fma((real)grid.x_x, d.x, fma((real)grid.x_y, d.y, (real)grid.x_z * d.z)),
                      fma((real)grid.y_x, d.x, fma((real)grid.y_y, d.y, (real)grid.y_z * d.z)),
                      fma((real)grid.z_x, d.x, fma((real)grid.z_y, d.y, (real)grid.z_z * d.z)));
}

/// The grid of one channel of a grid with three: 0, 1 or 2.
PURE GridRecord grid_channel(GridRecord grid, uint channel)
{
    grid.first += channel * (grid.size_x * grid.size_y * grid.size_z);
    return grid;
}

/// A whole-numbered voxel number, clamped to the grid; not a number is voxel 0.
PURE bits voxel_number(real i, uint size) { return to_bits(fmin(fmax(i, R(0.0)), (real)(float)(size - 1u))); }

PURE GridCell load_cell(GridRecord grid, __global const float* voxels, real3 cell)
{
    bits x0 = voxel_number(cell.x - R(1.0), grid.size_x), x1 = voxel_number(cell.x, grid.size_x);
    bits y0 = voxel_number(cell.y - R(1.0), grid.size_y) * grid.size_x, y1 = voxel_number(cell.y, grid.size_y) * grid.size_x;
    uint layer = grid.size_x * grid.size_y;
    bits z0 = voxel_number(cell.z - R(1.0), grid.size_z) * layer + grid.first, z1 = voxel_number(cell.z, grid.size_z) * layer + grid.first;
    GridCell c;
    c.v000 = gather_lanes(voxels, z0 + y0 + x0), c.v100 = gather_lanes(voxels, z0 + y0 + x1);
    c.v010 = gather_lanes(voxels, z0 + y1 + x0), c.v110 = gather_lanes(voxels, z0 + y1 + x1);
    c.v001 = gather_lanes(voxels, z1 + y0 + x0), c.v101 = gather_lanes(voxels, z1 + y0 + x1);
    c.v011 = gather_lanes(voxels, z1 + y1 + x0), c.v111 = gather_lanes(voxels, z1 + y1 + x1);
    return c;
}

/// Position between the two centres of a cell, in [0, 1]. The clamp only takes away what rounding put outside, so that values never leave the range of
/// their corners; not a number stays one.
PURE real between_centres(real at, real cell)
{
    real f = at - (cell - R(0.5));
    f = select(f, R(0.0), f < R(0.0));
    return select(f, R(1.0), f > R(1.0));
}

/// Trilinear between the corners, which are not negative, and so it is not: b - a >= -a also when rounded. No fma: nothing cancels, and on the host each would
/// be a call of the library.
PURE real value_in_cell(GridCell c, real x, real y, real z)
{
    real v00 = c.v000 + x * (c.v100 - c.v000), v10 = c.v010 + x * (c.v110 - c.v010);
    real v01 = c.v001 + x * (c.v101 - c.v001), v11 = c.v011 + x * (c.v111 - c.v011);
    real v0 = v00 + y * (v10 - v00), v1 = v01 + y * (v11 - v01);
    return v0 + z * (v1 - v0);
}

/// The cell number along one axis for a position; on a plane between two cells the one that is ahead.
PURE real cell_number(real at, real way, uint size)
{
    real shifted = at + R(0.5), cell = floor(shifted);
    cell = cell - select(R(0.0), R(1.0), (way < R(0.0)) & (cell == shifted));
    return fmin(fmax(cell, R(0.0)), (real)(float)size);
}

/// Value at a point of render space, which is moved into the box along its axes if it lies outside.
PURE real grid_value_clamped(GridRecord grid, __global const float* voxels, real3 point)
{
    real3 at = to_grid(grid, point), none = make_real3(R(0.0), R(0.0), R(0.0));
    real3 cell = make_real3(cell_number(at.x, none.x, grid.size_x), cell_number(at.y, none.y, grid.size_y), cell_number(at.z, none.z, grid.size_z));
    return value_in_cell(load_cell(grid, voxels, cell), between_centres(at.x, cell.x), between_centres(at.y, cell.y), between_centres(at.z, cell.z));
}

/// Does the point of render space lie outside of the box? Its faces belong to it; a point that is not a number does not lie outside.
PURE mask outside_grid(GridRecord grid, real3 point)
{
    real3 at = to_grid(grid, point);
    return (at.x < R(0.0)) | (at.x > (real)(float)grid.size_x) | (at.y < R(0.0)) | (at.y > (real)(float)grid.size_y) | (at.z < R(0.0)) |
           (at.z > (real)(float)grid.size_z);
}

/// Value at a point of render space: 0 outside of the box.
PURE real grid_value(GridRecord grid, __global const float* voxels, real3 point)
{
    return select(grid_value_clamped(grid, voxels, point), R(0.0), outside_grid(grid, point));
}

/// t at which a cell is left along one axis: from the number of the plane, never by adding up.
PURE real cell_left(real cell, real start, real way, real inverse)
{
    real plane = cell + select(R(0.5), R(-0.5), way < R(0.0));
    return select((plane - start) * inverse, GRID_NEVER, fabs(way) < GRID_STILL);
}

PURE GridWalk find_leaves(GridWalk w)
{
    w.leaves.x = cell_left(w.cell.x, w.start.x, w.way.x, w.inverse.x);
    w.leaves.y = cell_left(w.cell.y, w.start.y, w.way.y, w.inverse.y);
    w.leaves.z = cell_left(w.cell.z, w.start.z, w.way.z, w.inverse.z);
    return w;
}

/// Part of an interval of t where 0 <= start + t way <= size.
PURE ClipInterval clip_slab(ClipInterval c, real start, real way, uint size)
{
    c = clip_half_space(c.enter, c.leave, start, -way);
    return clip_half_space(c.enter, c.leave, (real)(float)size - start, way);
}

/// A segment between two points of render space at its first cell. Where it misses the box there is no cell: t = end.
PURE GridWalk begin_grid_walk(GridRecord grid, real3 from, real3 to)
{
    GridWalk w;
    w.start = to_grid(grid, from), w.way = direction_to_grid(grid, sub3(to, from));
    ClipInterval inside = {R(0.0), R(1.0)};
    inside = clip_slab(inside, w.start.x, w.way.x, grid.size_x);
    inside = clip_slab(inside, w.start.y, w.way.y, grid.size_y);
    inside = clip_slab(inside, w.start.z, w.way.z, grid.size_z);
    mask meets = inside.enter < inside.leave;
    w.t = select(R(0.0), inside.enter, meets), w.end = select(R(0.0), inside.leave, meets);  // a t of a miss may be anything
    w.inverse = make_real3(R(1.0) / w.way.x, R(1.0) / w.way.y, R(1.0) / w.way.z);
    real3 at = along3(w.start, w.t, w.way);
    w.cell = make_real3(cell_number(at.x, w.way.x, grid.size_x), cell_number(at.y, w.way.y, grid.size_y), cell_number(at.z, w.way.z, grid.size_z));
    return find_leaves(w);
}

/// More pieces than this there are not: each but the last ends at a plane of centres, of which there are size along an axis; rounding adds one per axis.
PURE uint most_grid_pieces(GridRecord grid) { return grid.size_x + grid.size_y + grid.size_z + 4u; }

PURE mask walks_grid(GridWalk w) { return w.t < w.end; }

/// t at which the piece in the present cell ends; w.t where nothing is left.
PURE real piece_end(GridWalk w) { return fmin(w.end, fmax(w.t, fmin(w.leaves.x, fmin(w.leaves.y, w.leaves.z)))); }

/// To the next cell, along every axis whose plane comes first: through edges and corners in one step.
PURE GridWalk next_cell(GridWalk w)
{
    real first = fmin(w.leaves.x, fmin(w.leaves.y, w.leaves.z));
    w.t = piece_end(w);
    w.cell.x += select(R(0.0), select(R(1.0), R(-1.0), w.way.x < R(0.0)), w.leaves.x <= first);
    w.cell.y += select(R(0.0), select(R(1.0), R(-1.0), w.way.y < R(0.0)), w.leaves.y <= first);
    w.cell.z += select(R(0.0), select(R(1.0), R(-1.0), w.way.z < R(0.0)), w.leaves.z <= first);
    return find_leaves(w);
}

/// Value at t, which lies in the present cell.
PURE real walk_value(GridWalk w, GridCell c, real t)
{
    real3 at = make_real3(w.start.x + t * w.way.x, w.start.y + t * w.way.y, w.start.z + t * w.way.z);
    return value_in_cell(c, between_centres(at.x, w.cell.x), between_centres(at.y, w.cell.y), between_centres(at.z, w.cell.z));
}

/// Integral of the value over [t0, t1] in the present cell: two Gauss points, exact for its cubic.
PURE real walk_integral(GridWalk w, GridCell c, real t0, real t1)
{
    real half_way = R(0.5) * (t1 - t0), middle = t0 + half_way, off = half_way * R(0.57735026918962576);
    return half_way * (walk_value(w, c, middle - off) + walk_value(w, c, middle + off));
}

/// 0 where every voxel coordinate of the walk is finite, else not a number: what clamped indices read is not worth anything there.
PURE real not_finite(GridWalk w) { return R(0.0) * (w.start.x + w.start.y + w.start.z + w.way.x + w.way.y + w.way.z); }

/// Integral of the value over a segment of the given length between two points of render space.
PURE real grid_optical_depth(GridRecord grid, __global const float* voxels, real3 from, real3 to, real length)
{
    GridWalk w = begin_grid_walk(grid, from, to);
    real sum = not_finite(w);
    uint most = most_grid_pieces(grid);
    for (uint i = 0; i < most; ++i) {
        if (!any_lane(walks_grid(w))) break;
        sum += walk_integral(w, load_cell(grid, voxels, w.cell), w.t, piece_end(w));
        w = next_cell(w);
    }
    return sum * length;
}

/// The same for the three channels of a grid, r, g and b.
PURE real3 grid_optical_depth3(GridRecord grid, __global const float* voxels, real3 from, real3 to, real length)
{
    GridWalk w = begin_grid_walk(grid, from, to);
    real3 sum = make_real3(not_finite(w), not_finite(w), not_finite(w));
    uint most = most_grid_pieces(grid);
    for (uint i = 0; i < most; ++i) {
        if (!any_lane(walks_grid(w))) break;
        real t1 = piece_end(w);
        sum.x += walk_integral(w, load_cell(grid, voxels, w.cell), w.t, t1);
        sum.y += walk_integral(w, load_cell(grid_channel(grid, 1u), voxels, w.cell), w.t, t1);
        sum.z += walk_integral(w, load_cell(grid_channel(grid, 2u), voxels, w.cell), w.t, t1);
        w = next_cell(w);
    }
    return make_real3(sum.x * length, sum.y * length, sum.z * length);
}

#endif
