// Something can occlude: for a tile of eye groups x one block of lights, write every pair's contribution and its shadow segment.
#include "kernels/stages/pair_stage.h"

__kernel void sample_pairs(__global const EyeRecord* eyes, uint first_group, uint groups, __global const Light* lights, uint first, uint count,
                           uint samples, uint vertex_limit, SURROUNDINGS_PARAMETERS, TABLES_PARAMETERS, __global const LightChoice* choices, uint slots,
                            __global ShadowPacket* packets, __global float* contributions,
                           __global uint* ledger)
{
    uint local_group = (uint)get_global_id(0), pairs = count * samples;
    if (local_group >= groups) return;
    uint group = first_group + local_group;
    Surroundings s = SURROUNDINGS;
    Eye eye = load_eye(eyes, group, s);
    EyeGroup around;
    find_group(&around, s, eye, eyes, group, choices, slots);
    uint packet_row = local_group * LANES / SHADOW_PACKET_SIZE * pairs, offset = local_group * LANES % SHADOW_PACKET_SIZE;
    for (uint pair = 0; pair < pairs; pair += PAIR_BATCH) {
        OnBoth places[PAIR_BATCH];
        Connection connections[PAIR_BATCH];
        uint batch = min((uint)PAIR_BATCH, pairs - pair), counter = first * samples + pair;
        place_pairs(places, eye, &around, lights, s, counter, batch, samples);
        connect_pairs(connections, eye, &around, lights, s, places, counter, batch, samples);
        for (uint i = 0; i < batch; ++i) {
            Connection c = connections[i];
            c.radiance = counted_radiance(eye, &around, lights, c, samples, vertex_limit, counter + i, ledger);
            ClampedRadiance r = clamped_radiance(c, c.radiance);
            __global float* contribution = contributions + (local_group * pairs + pair + i) * 3u * SUMS_OF_EYE * LANES;
            store_lanes(r.kept.x, 0, contribution), store_lanes(r.kept.y, 1, contribution), store_lanes(r.kept.z, 2, contribution);
            if (CLAMPS) store_lanes(r.removed.x, 3, contribution), store_lanes(r.removed.y, 4, contribution), store_lanes(r.removed.z, 5, contribution);
            store_shadow_segment(c, packets + packet_row + pair + i, offset);
        }
    }
}
