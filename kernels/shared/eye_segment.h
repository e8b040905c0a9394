/// A straight piece of a camera path inside one medium. Render space; 64 bytes.
#ifndef EYE_SEGMENT_H
#define EYE_SEGMENT_H

typedef struct {
    float origin_x, origin_y, origin_z, length;
    float direction_x, direction_y, direction_z;  ///< unit
    uint medium;
    float throughput_r, throughput_g, throughput_b;  ///< of the camera path up to the origin
    uint depth;                                      ///< scattering vertices (mirror and glass) before the origin
    uint pixel, key;                                 ///< row-major in the crop window; random key, a function of (seed, pass, pixel, piece)
    uint padding_0, padding_1;
} EyeSegment;
LAYOUT(EyeSegment, 64)

#endif
