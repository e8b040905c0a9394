/// What every kind of virtual light and every stage speak of: eyes, media and connections as lanes.
#ifndef EYE_AND_LIGHT_H
#define EYE_AND_LIGHT_H

#include "kernels/math/phase_lobes.h"
#include "kernels/math/rod_table.h"
#include "kernels/math/transmittance.h"
#include "kernels/shared/samplers.h"
#include "kernels/shared/scene_features.h"

/// What a connection carries if nothing blocks it, and where it runs.
typedef struct {
    real3 from, to;     ///< its ends: on the eye's side, on the light
    real length;        ///< |to - from|
    real3 radiance;     ///< towards the camera, without the transmittance of the connection itself
    mask floored;       ///< the pair all but meets: the floor on its distance was active; its weight is finite but unbounded
} Connection;

/// Where a connection runs and what the choice is worth: distances along light and eye segment, 1 / (w^2 pdf).
typedef struct {
    real v, u, weight;
    mask floored;  ///< the floor on the pair's distance was active (eq. 7)
} Places;

/// A medium per lane.
typedef struct {
    real3 sigma_t, sigma_s;
    real g;
    PhaseLanes phase;  ///< PHASE_LOBES: their phase functions
} MediumLanes;

typedef struct {
    real3 origin, direction, throughput;
    real length;
} EyeSegmentLanes;

typedef struct {
    real3 position, normal, facing, throughput;
} EyePointLanes;

/// Transmittance per channel of optical depths.
PURE real3 transmittance3(real3 depth)
{
    real first = transmittance(depth.x);
    if (!(COLOURED | COLOURED_GRIDS)) return make_real3(first, first, first);
    return make_real3(first, transmittance(depth.y), transmittance(depth.z));
}

/// Phase function at the light, whose light travels along b; d: from the eye to the light, of that length. Length 0: direction (0, 0, 0), whose phase is finite.
PURE real phase_of_light(real3 b, MediumRecord medium, PhaseTables tables, real3 d, real length)
{
    if (!ANISOTROPIC) return phase_isotropic();
    return phase_of(phase_range(medium), tables, b, scale3(d, R(-1.0) / fmax(length, R(1e-30))));
}

/// Product of the phase functions at the light and on the eye segment.
PURE real phase_of_both(EyeSegmentLanes eye, MediumLanes eye_medium, real3 b, MediumRecord medium, PhaseTables tables, real3 d, real length)
{
    if (!ANISOTROPIC) return phase_isotropic() * phase_isotropic();
    real3 towards_eye = scale3(d, R(-1.0) / fmax(length, R(1e-30)));
    return phase_of(phase_range(medium), tables, b, towards_eye) *
           phase_of_lanes(eye_medium.phase, tables, eye_medium.g, towards_eye, scale3(eye.direction, R(-1.0)));
}

/// The numbers of the sampler that the kernel is built for.
PURE TableShape table_shape(void)
{
    TableShape shape = {SAMPLER_NODES, SAMPLER_ANGLES, ANISOTROPIC};
    return shape;
}
PURE WarpShape warp_shape(void)
{
    WarpShape shape = {SAMPLER_VERTICES, ANISOTROPIC, SAMPLER_ABSORBS};
    return shape;
}

#endif
