/// What a grid answers about one segment, so that the same cases run on the host and on a device. Written in the kernels' dialect.
#ifndef EVALUATE_GRID_H
#define EVALUATE_GRID_H

#include "kernels/math/maths.h"
#include "kernels/volumes/grid_walk.h"

typedef struct {
    real depth, value, clamped;  ///< of the segment; at its beginning; the same, moved into the box
    real last;                   ///< three channels: depth of the last one
} GridOutputs;

PURE GridOutputs evaluate_grid(GridRecord grid, __global const float* voxels, uint channels, real3 from, real3 to)
{
    GridOutputs o;
    real length = length3(sub3(to, from));
    o.depth = grid_optical_depth(grid, voxels, from, to, length);
    o.value = grid_value(grid, voxels, from);
    o.clamped = grid_value_clamped(grid, voxels, from);
    o.last = o.depth;
    if (channels == 3u) {
        real3 depth = grid_optical_depth3(grid, voxels, from, to, length);
        o.depth = depth.x, o.last = depth.z;
    }
    return o;
}

#endif
