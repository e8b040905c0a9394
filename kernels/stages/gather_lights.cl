// Nothing can occlude: for LANES neighbouring eyes, add what lights first .. first + count send them. `first` is a multiple of LIGHT_BLOCK.
#include "kernels/stages/pair_stage.h"

__kernel void gather_lights(__global const EyeRecord* eyes, uint first_group, uint groups, __global const Light* lights, uint first, uint count,
                            uint samples, uint vertex_limit, SURROUNDINGS_PARAMETERS, TABLES_PARAMETERS, __global const LightChoice* choices, uint slots,
                            __global float* sums, __global uint* ledger, __global float* worst, __global uint* worst_counters)
{
    uint local_group = (uint)get_global_id(0);
    if (local_group >= groups) return;
    uint group = first_group + local_group;
    Surroundings s = SURROUNDINGS;
    Eye eye = load_eye(eyes, group, s);
    EyeGroup around;
    find_group(&around, s, eye, eyes, group, choices, slots);
    LongSum3 sum = load_sums(sums, group * SUMS_OF_EYE), lost = load_sums(sums, group * SUMS_OF_EYE + SUMS_OF_EYE - 1u);
    Worst largest = no_worst();
    for (uint block = first; block < first + count; block += LIGHT_BLOCK) {
        real3 partial = make_real3(R(0.0), R(0.0), R(0.0)), removed = partial;
        uint end = min(block + LIGHT_BLOCK, first + count) * samples;
        for (uint pair = block * samples; pair < end; pair += PAIR_BATCH) {
            OnBoth places[PAIR_BATCH];
            Connection connections[PAIR_BATCH];
            uint batch = min((uint)PAIR_BATCH, end - pair);
            place_pairs(places, eye, &around, lights, s, pair, batch, samples);
            connect_pairs(connections, eye, &around, lights, s, places, pair, batch, samples);
            for (uint i = 0; i < batch; ++i) {
                ClampedRadiance r = clamped_radiance(connections[i], counted_radiance(eye, &around, lights, connections[i], samples, vertex_limit, pair + i, ledger));
                largest = worse(largest, r.kept, (bits)(pair + i));
                partial = add3(partial, r.kept);
                if (CLAMPS) removed = add3(removed, r.removed);
            }
        }
        sum = add_block(sum, partial);
        if (CLAMPS) lost = add_block(lost, removed);
    }
    store_sums(sum, sums, group * SUMS_OF_EYE);
    if (CLAMPS) store_sums(lost, sums, group * SUMS_OF_EYE + 1u);
    keep_worst(largest, group, worst, worst_counters);
}
