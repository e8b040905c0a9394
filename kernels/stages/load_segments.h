// Eye segments as the stages hold them.
#ifndef LOAD_SEGMENTS_H
#define LOAD_SEGMENTS_H

typedef EyeSegment EyeRecord;
typedef struct {
    EyeSegmentLanes geometry;
    MediumLanes medium;
    bits key, depth, medium_index;
} Eye;

PURE Eye load_eye(__global const EyeRecord* eyes, uint group, Surroundings s)
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

/// What lies along an eye up to the distance u and what scatters there, exactly: from its table, with the interval of the place walked cell by cell.
PURE Matter exact_matter_along_eye(Surroundings s, const MediaOfGroup* media, Eye eye, const OpticalTable* table, real u)
{
    EyeSegmentLanes g = eye.geometry;
    TableNode node = node_below(*table, u, g.length);
    real3 point = along3(g.origin, u, g.direction), from = along3(g.origin, node.x, g.direction);
    Matter m = {add3(node.path, exact_path_of_group(s, media, from, scale3(g.direction, u - node.x), u - node.x)), scattering_of_group(s, media, point)};
    return m;
}

enum { EYES_HAVE_TABLES = 1 };
PURE real eye_length(Eye eye) { return eye.geometry.length; }

#endif
