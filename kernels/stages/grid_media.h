// What density grids hold at points and along segments, for media that may differ from lane to lane.
#ifndef GRID_MEDIA_H
#define GRID_MEDIA_H

/// Nearly the grid's value at points, per channel if it has three. `clamped`: points outside of its box count as moved into it; else the value is 0 there.
static inline real3 nearly_grid_values(Surroundings s, uint index, uint coloured, uint clamped, real3 point)
{
    GridRecord grid = s.grids[index];
    GridLookup l = grid_lookup(grid);
    __global const uint* first = s.packed_voxels + grid.first;
    real3 at = to_grid(grid, point);
    real zero = R(0.0), value = look_up(l, first, at);
    real3 values = make_real3(value, value, value);
    if (coloured) values.y = look_up(l, first + l.layer * grid.size_z, at), values.z = look_up(l, first + 2u * l.layer * grid.size_z, at);
    if (clamped) return values;
    return select3(values, make_real3(zero, zero, zero), beyond_box(grid, at));
}

/// The same exactly.
static inline real3 exact_grid_values(Surroundings s, uint index, uint coloured, uint clamped, real3 point)
{
    GridRecord grid = s.grids[index];
    real zero = R(0.0), value = grid_value_clamped(grid, s.voxels, point);
    real3 values = make_real3(value, value, value);
    if (coloured) {
        values.y = grid_value_clamped(grid_channel(grid, 1u), s.voxels, point);
        values.z = grid_value_clamped(grid_channel(grid, 2u), s.voxels, point);
    }
    if (clamped) return values;
    return select3(values, make_real3(zero, zero, zero), outside_grid(grid, point));
}
static inline real3 grid_values(Surroundings s, uint index, uint coloured, uint clamped, real3 point, uint exact)
{
    if (exact) return exact_grid_values(s, index, coloured, clamped, point);
    return nearly_grid_values(s, index, coloured, clamped, point);
}

/// Density x albedo of one medium.
static inline real3 scattering_at(Surroundings s, MediumRecord m, real3 point, uint exact)
{
    real3 scattering = make_real3(R(1.0), R(1.0), R(1.0));
    if (m.density_grid != NO_GRID) scattering = grid_values(s, m.density_grid, m.grid_colours & DENSITY_GRID_COLOURED, 0u, point, exact);
    if (m.albedo_grid != NO_GRID) scattering = mul3(scattering, grid_values(s, m.albedo_grid, m.grid_colours & ALBEDO_GRID_COLOURED, 1u, point, exact));
    return scattering;
}

/// The same with a medium per lane.
static inline real3 scattering_of_group(Surroundings s, const MediaOfGroup* group, real3 point, uint exact)
{
    real3 scattering = scattering_at(s, s.media[group->medium[0]], point, exact);
    for (uint i = 1; i < group->count; ++i)
        scattering = select3(scattering, scattering_at(s, s.media[group->medium[i]], point, exact), to_mask(group->of_lane == group->medium[i]));
    return scattering;
}

/// Integral of one medium's density, per channel, over the part enter <= t <= leave of the segment from + t d, |d| = length, cell by cell.
static inline real3 exact_path(Surroundings s, MediumRecord m, real3 from, real3 d, real length, real enter, real leave)
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
static inline real3 exact_path_of_group(Surroundings s, const MediaOfGroup* group, real3 from, real3 d, real length)
{
    real3 path = exact_path(s, s.media[group->medium[0]], from, d, length, R(0.0), R(1.0));
    for (uint i = 1; i < group->count; ++i)
        path = select3(path, exact_path(s, s.media[group->medium[i]], from, d, length, R(0.0), R(1.0)), to_mask(group->of_lane == group->medium[i]));
    return path;
}

/// Its estimate by a march whose steps are shifted by `jitter` in [0, 1).
static inline real3 marched_path(Surroundings s, MediumRecord m, real3 from, real3 d, real length, real enter, real leave, real jitter)
{
    real part = fmax(leave - enter, R(0.0)) * length;
    if (m.density_grid == NO_GRID) return make_real3(part, part, part);
    GridRecord grid = s.grids[m.density_grid];
    GridMarch march = begin_grid_march(grid, from, d, enter, leave, jitter);
    return scale3(march_grid(grid, s.packed_voxels, march, COLOURED_GRIDS && (m.grid_colours & DENSITY_GRID_COLOURED) ? 3u : 1u), length);
}

#endif
