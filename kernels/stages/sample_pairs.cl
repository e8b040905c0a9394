// Something can occlude: for a tile of eye groups x one block of lights, write every pair's contribution and its shadow segment.
#include "kernels/stages/pair_stage.h"

__kernel void sample_pairs(__global const EyeRecord* eyes, uint first_group, uint groups, __global const Light* lights, uint first, uint count,
                           uint samples, uint vertex_limit, __global const MediumRecord* media, __global const ContainerRecord* containers,
                           uint container_count, __global const PlaneRecord* planes, __global ShadowPacket* packets, __global float* contributions,
                           __global uint* ledger)
{
    uint local_group = get_global_id(0), pairs = count * samples;
    if (local_group >= groups) return;
    uint group = first_group + local_group;
    Surroundings s = {media, containers, planes, container_count};
    Eye eye = load_eye(eyes, group, media);
    FacingPlanes facing;
    find_facing_planes(&facing, s, eye_position(eye));
    uint packet_row = local_group * LANES / SHADOW_PACKET_SIZE * pairs, offset = local_group * LANES % SHADOW_PACKET_SIZE;
    for (uint pair = 0; pair < pairs; ++pair) {
        uint i = first + pair / samples;
        Connection c = connect_counted(eye, &facing, lights[i], s, vertex_limit, i * samples + pair % samples, ledger, group);
        __global float* contribution = contributions + (local_group * pairs + pair) * 3u * LANES;
        store_lanes(c.radiance.x, 0, contribution), store_lanes(c.radiance.y, 1, contribution), store_lanes(c.radiance.z, 2, contribution);
        store_shadow_segment(c, packets + packet_row + pair, offset);
    }
}
