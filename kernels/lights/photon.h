/// A photon: light that arrives at a surface. Eye points that lie within its radius take from it what the surface there reflects towards the camera (kernels/README.md, section 19). Biased, and
/// less so the smaller the radius. No connection is made, so nothing can stand between.
#ifndef PHOTON_H
#define PHOTON_H

#include "kernels/math/blur.h"
#include "kernels/math/eye_and_light.h"

typedef struct {
    float position_x, position_y, position_z;
    float radius;                                 ///< > 0
    float direction_x, direction_y, direction_z;  ///< unit, of travel
    uint depth;                                   ///< scattering vertices before the surface
    float power_r, power_g, power_b;              ///< W that arrive
    uint padding_0;
    float facing_x, facing_y, facing_z;           ///< geometric normal of the side at which it arrives, unit
    uint padding_1;
} Photon;
LAYOUT(Photon, 64)

typedef Photon Light;

enum { LIGHT_IS_LINE = 0 };
PURE uint light_medium(Photon light) { return 0u; }  // what it came through is in its power
PURE uint light_depth(Photon light) { return light.depth; }
PURE real3 light_origin(Photon light) { return make_real3((real)light.position_x, (real)light.position_y, (real)light.position_z); }
PURE real3 light_direction(Photon light) { return make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z); }
PURE float light_length(Photon light) { return 0.0f; }
PURE uint light_is_even(Photon light) { return 1u; }

/// Only on surfaces that face the way the photon's own does: not on the other side of a sheet, nor round an edge.
PURE Meeting meet_point(EyePointLanes eye, Photon light)
{
    real3 d = sub3(eye.position, light_origin(light)), facing = make_real3((real)light.facing_x, (real)light.facing_y, (real)light.facing_z);
    Meeting m;
    m.u = m.v = R(0.0);
    m.weight = select(R(0.0), blur_over_plane(dot3(d, d), (real)light.radius), dot3(eye.facing, facing) > R(0.0));
    return m;
}

/// Radiance towards the camera. The photon's power is spread over the area of the true surface; the cosine at the shading normal takes the place of that at the geometric one (eq. 69).
PURE real3 gather_at_point(EyePointLanes eye, Photon light, Meeting at)
{
    real3 towards = scale3(light_direction(light), R(-1.0));
    real over_surface = dot3(towards, eye.facing), over_shading = dot3(towards, eye.normal);
    mask lit = (over_surface > R(0.0)) & (over_shading > R(0.0));
    real share = select(R(0.0), over_shading / select(R(1.0), over_surface, lit), lit);
    real3 power = make_real3((real)light.power_r, (real)light.power_g, (real)light.power_b);
    return scale3(mul3(power, eye.throughput), at.weight * share);
}

#endif
