// Eye points as the stages hold them.
#ifndef LOAD_POINTS_H
#define LOAD_POINTS_H

typedef EyePoint EyeRecord;
typedef struct {
    EyePointLanes geometry;
    bits key, depth, medium_index;
} Eye;

PURE Eye load_eye(__global const EyeRecord* eyes, uint group, Surroundings s)
{
#define FIELD(name) load_field(&eyes->name, sizeof(EyeRecord) / 4, group)
#define FIELD_BITS(name) load_field_bits(&eyes->name, sizeof(EyeRecord) / 4, group)
    Eye eye;
    eye.geometry.position = make_real3(FIELD(position_x), FIELD(position_y), FIELD(position_z));
    eye.geometry.normal = make_real3(FIELD(normal_x), FIELD(normal_y), FIELD(normal_z));
    eye.geometry.facing = make_real3(FIELD(facing_x), FIELD(facing_y), FIELD(facing_z));
    eye.geometry.throughput = make_real3(FIELD(throughput_r), FIELD(throughput_g), FIELD(throughput_b));
    eye.key = FIELD_BITS(key), eye.depth = FIELD_BITS(depth), eye.medium_index = FIELD_BITS(medium);
#undef FIELD
#undef FIELD_BITS
    return eye;
}

enum { EYES_HAVE_TABLES = 0 };
PURE real eye_length(Eye eye) { return R(0.0); }

#endif
