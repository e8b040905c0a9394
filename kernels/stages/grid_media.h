// What density grids hold at points and along segments, for media that may differ from lane to lane.
#ifndef GRID_MEDIA_H
#define GRID_MEDIA_H

/// A grid's value at points. `clamped`: points outside of its box count as moved into it; else the value is 0 there. One function for all who ask, with
/// arguments that fit into registers: written out at every place it takes compilers seconds.
APART real grid_value_of_channel(__global const GridRecord* grids, uint index, __global const float* voxels, uint channel, uint clamped, real x, real y, real z)
{
    GridRecord grid = grids[index];
    GridLookup l = grid_lookup(grid);
    real3 at = to_grid(grid, make_real3(x, y, z));
    real value = value_at(l, voxels + grid.first + channel * (l.layer * grid.size_z), at);
    if (clamped) return value;
    return select(value, R(0.0), beyond_box(grid, at));
}

/// The same per channel, if it has three.
PURE real3 grid_values(Surroundings s, uint index, uint coloured, uint clamped, real3 point)
{
    real value = grid_value_of_channel(s.grids, index, s.voxels, 0u, clamped, point.x, point.y, point.z);
    real3 values = make_real3(value, value, value);
    if (coloured) {
        values.y = grid_value_of_channel(s.grids, index, s.voxels, 1u, clamped, point.x, point.y, point.z);
        values.z = grid_value_of_channel(s.grids, index, s.voxels, 2u, clamped, point.x, point.y, point.z);
    }
    return values;
}

/// Density x albedo of one medium.
PURE real3 scattering_at(Surroundings s, MediumRecord m, real3 point)
{
    real3 scattering = make_real3(R(1.0), R(1.0), R(1.0));
    if (m.density_grid != NO_GRID) scattering = grid_values(s, m.density_grid, m.grid_colours & DENSITY_GRID_COLOURED, 0u, point);
    if (m.albedo_grid != NO_GRID) scattering = mul3(scattering, grid_values(s, m.albedo_grid, m.grid_colours & ALBEDO_GRID_COLOURED, 1u, point));
    return scattering;
}

/// The same with a medium per lane.
PURE real3 scattering_of_group(Surroundings s, const MediaOfGroup* group, real3 point)
{
    real3 scattering = scattering_at(s, s.media[group->medium[0]], point);
    for (uint i = 1; i < group->count; ++i)
        scattering = select3(scattering, scattering_at(s, s.media[group->medium[i]], point), to_mask(group->of_lane == group->medium[i]));
    return scattering;
}

/// Integral of one medium's density, per channel, over the part enter <= t <= leave of the segment from + t d, |d| = length, cell by cell.
APART real3 exact_path(Surroundings s, MediumRecord m, real3 from, real3 d, real length, real enter, real leave)
{
    real part = fmax(leave - enter, R(0.0)) * length;
    if (m.density_grid == NO_GRID) return make_real3(part, part, part);
    GridRecord grid = s.grids[m.density_grid];
    real3 start = along3(from, enter, d), end = along3(from, fmax(leave, enter), d);
    if (COLOURED_GRIDS) {
        if (m.grid_colours & DENSITY_GRID_COLOURED) return grid_optical_depth3(grid, s.voxels, start, end, part);
    }
    real path = grid_optical_depth(grid, s.voxels, start, end, part);
    return make_real3(path, path, path);
}

/// The same with a medium per lane.
PURE real3 exact_path_of_group(Surroundings s, const MediaOfGroup* group, real3 from, real3 d, real length)
{
    real3 path = exact_path(s, s.media[group->medium[0]], from, d, length, R(0.0), R(1.0));
    for (uint i = 1; i < group->count; ++i)
        path = select3(path, exact_path(s, s.media[group->medium[i]], from, d, length, R(0.0), R(1.0)), to_mask(group->of_lane == group->medium[i]));
    return path;
}

/// The march through one channel of a coarse grid.
APART real march_coarse_grid(GridRecord grid, __global const float* voxels, uint channel, GridMarch march)
{
    GridLookup l = grid_lookup(grid);
    return march_values(l, voxels + grid.first + channel * (l.layer * grid.size_z), march);
}
PURE real march_channel(GridRecord grid, __global const float* voxels, uint channel, GridMarch march)
{
    GridLookup l = grid_lookup(grid);
    if (is_coarse(grid)) return march_coarse_grid(grid, voxels, channel, march);
    return march_voxels(l, voxels + grid.first + channel * (l.layer * grid.size_z), march);
}

/// Its estimate by a march.
PURE real3 marched_path(Surroundings s, MediumRecord m, real3 from, real3 d, real length, real enter, real leave, MarchShift shift)
{
    real part = fmax(leave - enter, R(0.0)) * length;
    if (m.density_grid == NO_GRID) return make_real3(part, part, part);
    GridRecord grid = s.grids[m.density_grid];
    GridMarch march = begin_grid_march(grid, from, d, enter, leave, shift);
    real path = march_channel(grid, s.voxels, 0u, march) * length;
    real3 paths = make_real3(path, path, path);
    if (COLOURED_GRIDS) {
        if (!(m.grid_colours & DENSITY_GRID_COLOURED)) return paths;
        paths.y = march_channel(grid, s.voxels, 1u, march) * length, paths.z = march_channel(grid, s.voxels, 2u, march) * length;
    }
    return paths;
}

#endif
