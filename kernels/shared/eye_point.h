/// The first surface of a camera path that is not specular, where it reflects diffusely. Render space; 64 bytes.
#ifndef EYE_POINT_H
#define EYE_POINT_H

typedef struct {
    float position_x, position_y, position_z;  ///< already moved off the surface
    uint medium;                               ///< in front of the surface; NO_MEDIUM for vacuum
    float normal_x, normal_y, normal_z;        ///< shading normal towards the camera's side, unit
    uint depth;                                ///< scattering vertices before this one
    float throughput_r, throughput_g, throughput_b;  ///< of the camera path, times reflectance / pi
    uint pixel;
    float facing_x, facing_y, facing_z;        ///< geometric normal towards the camera's side, unit
    uint key;
} EyePoint;
LAYOUT(EyePoint, 64)

#endif
