// Adds what was visible of a tile that sample_pairs wrote and the host answered: one block of lights for LANES neighbouring eyes.
#include "kernels/stages/pair_stage.h"

__kernel void accumulate_pairs(uint first_group, uint groups, uint first_pair, uint pairs, __global const ShadowPacket* packets, __global const float* contributions,
                               __global float* sums, __global float* worst, __global uint* worst_counters)
{
    uint local_group = (uint)get_global_id(0);
    if (local_group >= groups) return;
    uint packet_row = local_group * LANES / SHADOW_PACKET_SIZE * pairs, offset = local_group * LANES % SHADOW_PACKET_SIZE;
    real3 partial = make_real3(R(0.0), R(0.0), R(0.0)), removed = partial, zero = partial;
    Worst largest = no_worst();
    for (uint pair = 0; pair < pairs; ++pair) {
        __global const float* contribution = contributions + (local_group * pairs + pair) * 3u * SUMS_OF_EYE * LANES;
        real3 radiance = make_real3(load_lanes(contribution, 0), load_lanes(contribution, 1), load_lanes(contribution, 2));
        mask visible = load_lanes(packets[packet_row + pair].tfar + offset, 0) >= R(-1.0);   // blocked: -infinity; not asked: -1
        radiance = select3(zero, radiance, visible);
        largest = worse(largest, radiance, (bits)(first_pair + pair));
        partial = add3(partial, radiance);
        if (CLAMPS) {
            real3 lost = make_real3(load_lanes(contribution, 3), load_lanes(contribution, 4), load_lanes(contribution, 5));
            removed = add3(removed, select3(zero, lost, visible));
        }
    }
    uint group = first_group + local_group;
    store_sums(add_block(load_sums(sums, group * SUMS_OF_EYE), partial), sums, group * SUMS_OF_EYE);
    if (CLAMPS) store_sums(add_block(load_sums(sums, group * SUMS_OF_EYE + 1u), removed), sums, group * SUMS_OF_EYE + 1u);
    keep_worst(largest, group, worst, worst_counters);
}
