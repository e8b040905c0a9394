// One segment per lane through a density grid: its transmittance by one of several methods. The text of kernels/volumes/grid_march.h comes before.
// Build options: METHOD, one of those below; STEPS, of a march, 0: as many as it takes by itself.

#define METHOD_EXACT 0      // cell by cell
#define METHOD_VOXELS 1     // a march through single voxels
#define METHOD_VALUES 2     // a march through trilinear values
#define METHOD_CORRECTED 3  // the first march, with the exact value for one group of 16 segments in 64

PURE GridMarch with_steps(GridMarch m, MarchShift shift)
{
    if (STEPS == 0) return m;
    real change = m.steps / (real)(float)STEPS, back = shift.along * (change - R(1.0));
    m.start = along3(m.start, back, m.step);
    m.step = make_real3(m.step.x * change, m.step.y * change, m.step.z * change);
    m.share *= change, m.steps = (real)(float)STEPS;
    return m;
}

PURE real marched(GridRecord grid, __global const float* voxels, real3 from, real3 to, real length, bits random)
{
    MarchShift shift = march_shift(random);
    GridMarch m = with_steps(begin_grid_march(grid, from, sub3(to, from), R(0.0), R(1.0), shift), shift);
    GridLookup l = grid_lookup(grid);
    if (METHOD == METHOD_VALUES) return march_values(l, voxels + grid.first, m) * length;
    return march_voxels(l, voxels + grid.first, m) * length;
}

/// Coordinate f of segment i at segments[f count + i]; `count` is a multiple of 16.
__kernel void transmittances(__global const GridRecord* grids, __global const float* voxels, __global const float* segments, uint count, float sigma_t, uint seed,
                             __global float* out)
{
    uint group = get_global_id(0);
    if (group >= count / LANES) return;
    real3 from = make_real3(load_lanes(segments, group), load_lanes(segments + count, group), load_lanes(segments + 2 * count, group));
    real3 to = make_real3(load_lanes(segments + 3 * count, group), load_lanes(segments + 4 * count, group), load_lanes(segments + 5 * count, group));
    real length = length3(sub3(to, from)), sigma = (real)sigma_t, t;
    if (METHOD == METHOD_EXACT) {
        t = transmittance(sigma * grid_optical_depth(grids[0], voxels, from, to, length));
    } else {
        t = transmittance(sigma * marched(grids[0], voxels, from, to, length, mix_lanes(lane_index(group) + mix_scalar(seed))));
        if (METHOD == METHOD_CORRECTED && mix_scalar(group * LANES / 16u + mix_scalar(seed + 1u)) % 64u == 0u)
            t += R(64.0) * (transmittance(sigma * grid_optical_depth(grids[0], voxels, from, to, length)) - t);
    }
    store_lanes(t, group, out);
}
