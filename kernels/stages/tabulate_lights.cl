// Density grids: what lies along each light, once for every set of lights. One work-item per light; its intervals are the lanes.
#include "STAGE"

__kernel void tabulate_lights(__global const Light* lights, uint count, SURROUNDINGS_PARAMETERS, __global float* tables)
{
    uint number = (uint)get_global_id(0);
    if (number >= count) return;
    Surroundings s = SURROUNDINGS_WITHOUT_TABLES;
    Light light = lights[number];
    MediumRecord medium = medium_of(s, light);
    __global float* table = tables + (size_t)number * TABLE_FLOATS;
    real step = (real)(light_length(light) / (float)TABLE_INTERVALS);
    real3 origin = light_origin(light), direction = light_direction(light), d = scale3(direction, step);
    for (uint group = 0; group < TABLE_INTERVALS / LANES; ++group) {
        real3 path = exact_path(s, medium, along3(origin, to_real(lane_index(group)) * step, direction), d, step, R(0.0), R(1.0));
        store_lanes(path.x, group, table + 1);
        if (COLOURED_GRIDS) store_lanes(path.y, group, table + TABLE_NODES + 1u), store_lanes(path.z, group, table + 2u * TABLE_NODES + 1u);
    }
    float totals[3];
    for (uint channel = 0; channel < TABLE_CHANNELS; ++channel, table += TABLE_NODES) {
        float sum = 0.0f, lost = 0.0f;                       // long_sum.h, as one scalar
        table[0] = 0.0f;
        for (uint i = 1; i < TABLE_NODES; ++i) {
            float x = table[i], high = sum + x, back = high - sum;
            lost += (sum - (high - back)) + (x - back), sum = high;
            table[i] = sum + lost;
        }
        totals[channel] = sum + lost;
    }
    if (!COLOURED_GRIDS) totals[1] = totals[2] = totals[0];
    float masses[LANES];
    store_lanes(over_mass(grey(sigma_t_of(medium), make_real3((real)totals[0], (real)totals[1], (real)totals[2])), light_is_even(light)), 0, masses);
    *table = masses[0];
}
