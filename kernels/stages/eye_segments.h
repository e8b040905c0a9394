// What the stages call an eye, when eyes are segments: virtual light to medium.
#ifndef EYE_KIND_H
#define EYE_KIND_H

typedef EyeSegment EyeRecord;
typedef struct {
    EyeSegmentLanes geometry;
    MediumLanes medium;
    bits key, depth, medium_index;
} Eye;

static inline Eye load_eye(__global const EyeRecord* eyes, uint group, Surroundings s)
{
#define FIELD(name) load_field(&eyes->name, sizeof(EyeRecord) / 4, group)
#define FIELD_BITS(name) load_field_bits(&eyes->name, sizeof(EyeRecord) / 4, group)
    Eye eye;
    eye.geometry.origin = make_real3(FIELD(origin_x), FIELD(origin_y), FIELD(origin_z));
    eye.geometry.direction = make_real3(FIELD(direction_x), FIELD(direction_y), FIELD(direction_z));
    eye.geometry.throughput = make_real3(FIELD(throughput_r), FIELD(throughput_g), FIELD(throughput_b));
    eye.geometry.length = FIELD(length);
    eye.key = FIELD_BITS(key), eye.depth = FIELD_BITS(depth), eye.medium_index = FIELD_BITS(medium);
#undef FIELD
#undef FIELD_BITS
    eye.medium = load_media(s.media, eye.medium_index);
    return eye;
}

typedef RodSample OnLight;
typedef Places OnBoth;
static inline OnLight place_light(Eye eye, Light light, real xi) { return place_on_light(eye.geometry, light, xi); }
static inline OnBoth place_eye(Eye eye, Light light, MediumRecord medium, OnLight on_light, real xi)
{
    return place_on_segment(eye.geometry, eye.medium, light, medium, on_light, xi);
}
static inline Connection connect_eye(Eye eye, Light light, MediumRecord medium, OnBoth at)
{
    return connect_segment_at(eye.geometry, eye.medium, light, medium, at);
}

/// Where its connections start: all of a segment is inside the container whose medium it is in.
static inline real3 eye_position(Eye eye) { return along3(eye.geometry.origin, R(0.5) * eye.geometry.length, eye.geometry.direction); }

#endif
