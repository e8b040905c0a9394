// Media of a light and of a group of eyes.
#ifndef MEDIA_H
#define MEDIA_H

static inline MediumRecord medium_of(Surroundings s, Light light) { return s.media[MANY_MEDIA ? light.medium : 0u]; }

/// Media chosen per lane.
static inline MediumLanes load_media(__global const MediumRecord* media, bits index)
{
    MediumLanes lanes;
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
