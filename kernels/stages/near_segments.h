// What gather_near calls an eye, when eyes are segments: they take from light paths that pass near.
#ifndef NEAR_EYE_H
#define NEAR_EYE_H

#include "kernels/stages/load_segments.h"

PURE Meeting meet_eye(Eye eye, Surroundings s, Light light, real xi)
{
    Meeting m = meet_segment(eye.geometry, eye.medium, light, s.media[MANY_MEDIA ? light_medium(light) : 0u], xi);
    if (MANY_MEDIA) m.weight = select(R(0.0), m.weight, to_mask(eye.medium_index == light_medium(light)));
    return m;
}

PURE real3 gather_eye(Eye eye, const NearGroup* around, Surroundings s, Light light, uint number, Meeting at)
{
    MediumRecord medium = s.media[MANY_MEDIA ? light_medium(light) : 0u];
    Matter on_eye = even_matter(at.u), on_light = even_matter(at.v);
    if (HETEROGENEOUS) {
        on_eye = exact_matter_along_eye(s, &around->media, eye, &around->table, at.u);
        on_light = exact_matter_on_light(s, medium, light, number, at.v);
    }
    return gather_on_segment(eye.geometry, eye.medium, light, medium, phase_tables(s), at, on_eye, on_light);
}

#endif
