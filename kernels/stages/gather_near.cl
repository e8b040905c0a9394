// Density estimation: LANES neighbouring eyes take from the lights that come near one of their EYE_GROUP. `near` holds the numbers of those, `starts` where each group's begin.
#include "kernels/stages/near_stage.h"

PURE NearGroup near_group(Surroundings s, Eye eye, uint group)
{
    NearGroup around;
    around.table.stride = EYE_GROUP;
    if (!HETEROGENEOUS) return around;
    uint first = group * LANES / EYE_GROUP * EYE_GROUP;
    around.media = media_of_group(eye.medium_index);
    around.table.first = s.eye_tables + (size_t)first * TABLE_FLOATS;
    around.table.lane = lane_index(0) + (group * LANES - first);
    around.table.per_length = intervals_per_length(eye_length(eye));
    return around;
}

/// What is not finite is counted and taken out of the sum.
PURE real3 counted_radiance(real3 radiance, uint group, uint number, __global uint* ledger)
{
    mask finite = to_mask(isfinite(radiance.x + radiance.y + radiance.z));
    if (all_lanes(finite)) return radiance;
    if (atomic_add(&ledger[0], LANES - count_lanes(finite)) == 0u) ledger[1] = group * LANES, ledger[2] = number;
    return select3(make_real3(R(0.0), R(0.0), R(0.0)), radiance, finite);
}

__kernel void gather_near(__global const EyeRecord* eyes, uint first_group, uint groups, __global const Light* lights, uint vertex_limit, SURROUNDINGS_PARAMETERS, TABLES_PARAMETERS,
                          __global const uint* starts, __global const uint* near_lights, __global float* sums, __global uint* ledger, __global float* worst, __global uint* worst_counters)
{
    uint local_group = (uint)get_global_id(0);
    if (local_group >= groups) return;
    uint group = first_group + local_group, of_eyes = group * LANES / EYE_GROUP;
    Surroundings s = SURROUNDINGS;
    Eye eye = load_eye(eyes, group, s);
    NearGroup around = near_group(s, eye, group);
    LongSum3 sum = load_sums(sums, group);
    Worst largest = no_worst();
    for (uint block = starts[of_eyes]; block < starts[of_eyes + 1u]; block += LIGHT_BLOCK) {
        real3 partial = make_real3(R(0.0), R(0.0), R(0.0));
        for (uint i = block; i < min(block + LIGHT_BLOCK, starts[of_eyes + 1u]); ++i) {
            uint number = near_lights[i];
            Light light = lights[number];
            Meeting at = meet_eye(eye, s, light, random2(eye.key, number).first);
            if (DEPTH_LIMIT) at.weight = select(R(0.0), at.weight, to_mask(eye.depth + light_depth(light) + 1u <= vertex_limit));
            mask meets = at.weight > R(0.0);
            if (!any_lane(meets)) continue;
            real3 radiance = select3(make_real3(R(0.0), R(0.0), R(0.0)), gather_eye(eye, &around, s, light, number, at), meets);
            radiance = counted_radiance(radiance, group, number, ledger);
            largest = worse(largest, radiance, (bits)(number));
            partial = add3(partial, radiance);
        }
        sum = add_block(sum, partial);
    }
    store_sums(sum, sums, group);
    keep_worst(largest, group, worst, worst_counters);
}
