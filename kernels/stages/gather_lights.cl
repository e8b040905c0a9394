// Nothing can occlude: for LANES neighbouring eyes, add what lights first .. first + count send them. `first` is a multiple of LIGHT_BLOCK.
#include "kernels/stages/pair_stage.h"

__kernel void gather_lights(__global const EyeRecord* eyes, uint first_group, uint groups, __global const Light* lights, uint first, uint count,
                            uint samples, uint vertex_limit, __global const MediumRecord* media, __global const ContainerRecord* containers,
                            uint container_count, __global const PlaneRecord* planes, __global float* sums, __global uint* ledger)
{
    if (get_global_id(0) >= groups) return;
    uint group = first_group + get_global_id(0);
    Surroundings s = {media, containers, planes, container_count};
    Eye eye = load_eye(eyes, group, media);
    FacingPlanes facing;
    find_facing_planes(&facing, s, eye_position(eye));
    LongSum3 sum = load_sums(sums, group);
    for (uint block = first; block < first + count; block += LIGHT_BLOCK) {
        real3 partial = make_real3(R(0.0), R(0.0), R(0.0));
        uint end = min(block + LIGHT_BLOCK, first + count);
        for (uint i = block; i < end; ++i)
            for (uint k = 0; k < samples; ++k)
                partial = add3(partial, connect_counted(eye, &facing, lights[i], s, vertex_limit, i * samples + k, ledger, group).radiance);
        sum = add_block(sum, partial);
    }
    store_sums(sum, sums, group);
}
