/// A photon beam, after [Jarosz et al. 2011]: a straight piece of a light path inside a medium. Eye segments that come within its radius take from it what the medium there scatters towards
/// the camera (kernels/README.md, section 19). Biased, and less so the thinner it is. No connection is made, so nothing can stand between.
#ifndef PHOTON_BEAM_H
#define PHOTON_BEAM_H

#include "kernels/math/blur.h"
#include "kernels/math/ray_light.h"

typedef struct {
    RayLight ray;      ///< depth: scattering vertices before it
    float radius;      ///< > 0
    uint padding_0, padding_1, padding_2;
} PhotonBeam;
LAYOUT(PhotonBeam, 80)

typedef PhotonBeam Light;

enum { LIGHT_IS_LINE = 1 };
PURE uint light_medium(PhotonBeam light) { return light.ray.medium; }
PURE uint light_depth(PhotonBeam light) { return light.ray.depth; }
PURE real3 light_origin(PhotonBeam light) { return ray_origin(light.ray); }
PURE real3 light_direction(PhotonBeam light) { return ray_direction(light.ray); }
PURE float light_length(PhotonBeam light) { return light.ray.length; }
PURE uint light_is_even(PhotonBeam light) { return SHORT_LIGHTS && light.ray.is_short != 0u ? 1u : 0u; }

/// How fast what the camera sees of a beam that runs beside the eye segment fades along it, in the channel where it fades least; in grids no rate is known.
PURE real fading_beside(EyeSegmentLanes eye, MediumLanes eye_medium, PhotonBeam light, MediumRecord medium)
{
    if (HETEROGENEOUS && medium.density_grid != NO_GRID) return R(0.0);
    real along = light_is_even(light) ? R(0.0) : dot3(eye.direction, ray_direction(light.ray));
    real least = fmin(eye_medium.sigma_t.x, fmin(eye_medium.sigma_t.y, eye_medium.sigma_t.z));
    return least * fmax(R(1.0) + along, R(0.0));
}

PURE Meeting meet_segment(EyeSegmentLanes eye, MediumLanes eye_medium, PhotonBeam light, MediumRecord medium, real xi)
{
    return meet_beam(sub3(ray_origin(light.ray), eye.origin), eye.direction, eye.length, ray_direction(light.ray), (real)light.ray.length, (real)light.radius,
                     fading_beside(eye, eye_medium, light, medium), xi);
}

/// Radiance towards the camera. on_eye, on_light: what lies along both up to the places.
PURE real3 gather_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, PhotonBeam light, MediumRecord medium, PhaseTables tables, Meeting at, Matter on_eye, Matter on_light)
{
    real phase = phase_isotropic();
    if (ANISOTROPIC) phase = phase_of_lanes(eye_medium.phase, tables, eye_medium.g, ray_direction(light.ray), scale3(eye.direction, R(-1.0)));
    AlongLight along = along_light(light.ray, medium, on_light.path);
    real3 depth = make_real3(fma(eye_medium.sigma_t.x, on_eye.path.x, along.depth.x), fma(eye_medium.sigma_t.y, on_eye.path.y, along.depth.y),
                             fma(eye_medium.sigma_t.z, on_eye.path.z, along.depth.z));
    real3 scattering = mul3(eye_medium.sigma_s, make_real3((real)light.ray.flux_r, (real)light.ray.flux_g, (real)light.ray.flux_b));
    if (HETEROGENEOUS) scattering = mul3(scattering, on_eye.scattering);
    return scale3(mul3(mul3(scattering, eye.throughput), transmittance3(depth)), at.weight * phase / along.divisor);
}

#endif
