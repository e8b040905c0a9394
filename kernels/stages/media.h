// Media of a light and of a group of eyes.
#ifndef MEDIA_H
#define MEDIA_H

PURE MediumRecord medium_of(Surroundings s, Light light) { return s.media[MANY_MEDIA ? light_medium(light) : 0u]; }

/// The media of a group of eyes, each once.
typedef struct {
    uint count;
    uint medium[LANES];
    bits of_lane;
} MediaOfGroup;

PURE MediaOfGroup media_of_group(bits index)
{
    MediaOfGroup group;
    group.count = 1u, group.medium[0] = 0u, group.of_lane = (bits)(0u);
    if (!MANY_MEDIA) return group;
    uint indices[LANES];
    store_bits(index, 0, indices);
    group.count = 0u, group.of_lane = index;
    for (uint lane = 0; lane < LANES; ++lane) {
        bool known = false;
        for (uint i = 0; i < group.count; ++i) known = known || group.medium[i] == indices[lane];
        if (!known) group.medium[group.count++] = indices[lane];
    }
    return group;
}

/// Their phase functions.
PURE PhaseLanes load_phases(__global const MediumRecord* media, bits index)
{
    PhaseLanes lanes;
    lanes.count = 0u, lanes.has_lobes = 0u;
    if (!PHASE_LOBES) return lanes;
    MediaOfGroup group = media_of_group(index);
    lanes.count = group.count, lanes.which = group.of_lane;
    for (uint i = 0; i < group.count; ++i) {
        lanes.ranges[i] = phase_range(media[group.medium[i]]), lanes.medium[i] = group.medium[i];
        lanes.has_lobes |= lanes.ranges[i].lobe_count > 0u;
    }
    return lanes;
}

/// Media chosen per lane.
PURE MediumLanes load_media(__global const MediumRecord* media, bits index)
{
    MediumLanes lanes;
    lanes.phase = load_phases(media, index);
    if (!MANY_MEDIA) {
        lanes.sigma_t = make_real3((real)media->sigma_t_r, (real)media->sigma_t_g, (real)media->sigma_t_b);
        lanes.sigma_s = make_real3((real)media->sigma_s_r, (real)media->sigma_s_g, (real)media->sigma_s_b);
        lanes.g = (real)media->g;
        return lanes;
    }
    float value[7][LANES];
    uint indices[LANES];
    store_floats(index, 0, indices);
    for (uint lane = 0; lane < LANES; ++lane) {
        MediumRecord m = media[indices[lane]];
        value[0][lane] = m.sigma_t_r, value[1][lane] = m.sigma_t_g, value[2][lane] = m.sigma_t_b;
        value[3][lane] = m.sigma_s_r, value[4][lane] = m.sigma_s_g, value[5][lane] = m.sigma_s_b;
        value[6][lane] = m.g;
    }
    lanes.sigma_t = make_real3(load_lanes(value[0], 0), load_lanes(value[1], 0), load_lanes(value[2], 0));
    lanes.sigma_s = make_real3(load_lanes(value[3], 0), load_lanes(value[4], 0), load_lanes(value[5], 0));
    lanes.g = load_lanes(value[6], 0);
    return lanes;
}

#endif
