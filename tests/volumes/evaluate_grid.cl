// Evaluates one grid for `count` segments (a multiple of LANES): coordinate f of segment i at in[f * count + i], output k at out[k * count + i].
#include "tests/volumes/evaluate_grid.h"

__kernel void evaluate_segments(__global const GridRecord* grid, __global const float* voxels, uint channels, __global const float* in, uint count, __global float* out)
{
    uint group = get_global_id(0);
    if (group >= count / LANES) return;
    real3 from = make_real3(load_lanes(in, group), load_lanes(in + count, group), load_lanes(in + 2 * count, group));
    real3 to = make_real3(load_lanes(in + 3 * count, group), load_lanes(in + 4 * count, group), load_lanes(in + 5 * count, group));
    GridOutputs o = evaluate_grid(*grid, voxels, channels, from, to);
    store_lanes(o.depth, group, out), store_lanes(o.value, group, out + count);
    store_lanes(o.clamped, group, out + 2 * count), store_lanes(o.last, group, out + 3 * count);
}
