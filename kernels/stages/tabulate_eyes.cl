// Density grids: what lies along each eye segment, once for every set of eyes. Tables of EYE_GROUP neighbours lie together, whatever the lane width.
#include "STAGE"

__kernel void tabulate_eyes(__global const EyeRecord* eyes, uint groups, SURROUNDINGS_PARAMETERS, __global float* tables)
{
    uint group = (uint)get_global_id(0);
    if (group >= groups) return;
    Surroundings s = SURROUNDINGS_WITHOUT_TABLES;
    Eye eye = load_eye(eyes, group, s);
    MediaOfGroup own = media_of_group(eye.medium_index);
    __global float* table = tables + (size_t)(group * LANES / EYE_GROUP) * TABLE_FLOATS * EYE_GROUP + group * LANES % EYE_GROUP;
    LongSum3 sum = {{R(0.0), R(0.0)}, {R(0.0), R(0.0)}, {R(0.0), R(0.0)}};
    real step = eye.geometry.length / (real)(float)TABLE_INTERVALS;
    real3 d = scale3(eye.geometry.direction, step);
    for (uint i = 0; i < TABLE_NODES; ++i, table += EYE_GROUP) {
        store_lanes(sum.r.high + sum.r.low, 0, table);
        if (COLOURED_GRIDS) {
            store_lanes(sum.g.high + sum.g.low, 0, table + TABLE_NODES * EYE_GROUP);
            store_lanes(sum.b.high + sum.b.low, 0, table + 2u * TABLE_NODES * EYE_GROUP);
        }
        real3 from = along3(eye.geometry.origin, (real)(float)i * step, eye.geometry.direction);
        if (i < TABLE_INTERVALS) sum = add_block(sum, exact_path_of_group(s, &own, from, d, step));
    }
    real3 path = make_real3(sum.r.high + sum.r.low, sum.g.high + sum.g.low, sum.b.high + sum.b.low);
    store_lanes(over_mass(grey(eye.medium.sigma_t, path), 0u), 0, table + (TABLE_CHANNELS - 1u) * TABLE_NODES * EYE_GROUP);
}
