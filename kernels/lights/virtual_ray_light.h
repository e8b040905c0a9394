/// A virtual ray light [Novak et al. 2012]: a piece of a light path inside one medium, shining from everywhere along it. This file is what every stage
/// needs to know of it: the record `Light`, and one sample of its connection to an eye segment and to an eye point.
#ifndef VIRTUAL_RAY_LIGHT_H
#define VIRTUAL_RAY_LIGHT_H

typedef struct {
    float origin_x, origin_y, origin_z, length;
    float direction_x, direction_y, direction_z;  ///< unit, direction of travel
    uint medium;
    float flux_r, flux_g, flux_b;  ///< W: emitted power x throughput up to the origin / number of paths; no transmittance along the light
    uint depth;                    ///< scattering vertices before the origin
    float channel_r, channel_g, channel_b;  ///< short: probability that channel c chose the distance x its transmittance up to the origin; long: unused
    uint is_short;                          ///< 1: ends at its sampled collision and is divided by the probability of reaching v
} VirtualRayLight;
LAYOUT(VirtualRayLight, 64)

typedef VirtualRayLight Light;

/// What a connection carries if nothing blocks it, and where it runs.
typedef struct {
    real3 from, to;     ///< its ends: on the eye's side, on the light
    real length;        ///< |to - from|
    real3 radiance;     ///< towards the camera, without the transmittance of the connection itself
    mask floored;       ///< the pair all but meets: the floor on its distance was active; its weight is finite but unbounded
} Connection;

/// A medium per lane.
typedef struct {
    real3 sigma_t, sigma_s;
    real g;
} MediumLanes;

typedef struct {
    real3 origin, direction, throughput;
    real length;
} EyeSegmentLanes;

typedef struct {
    real3 position, normal, facing, throughput;
} EyePointLanes;

PURE real3 mul3(real3 a, real3 b) { return make_real3(a.x * b.x, a.y * b.y, a.z * b.z); }
PURE real3 scale3(real3 a, real s) { return make_real3(a.x * s, a.y * s, a.z * s); }

/// Transmittance per channel of optical depths.
PURE real3 transmittance3(real3 depth)
{
    real first = transmittance(depth.x);
    if (!COLOURED) return make_real3(first, first, first);
    return make_real3(first, transmittance(depth.y), transmittance(depth.z));
}

/// Exponents (to be negated) and divisor of the transmittance along a light up to v: long lights transmit exp(-sigma_t v) and divide by 1; short ones
/// divide by the probability that the sampled distance is beyond v, sum_j channel_j exp(-sigma_j v). Both are taken relative to the smallest
/// extinction that can have been chosen, so that neither underflows alone.
typedef struct {
    real3 depth;
    real divisor;
} AlongLight;
PURE AlongLight along_light(VirtualRayLight light, MediumRecord medium, real v)
{
    AlongLight along;
    real3 sigma = make_real3((real)medium.sigma_t_r, (real)medium.sigma_t_g, (real)medium.sigma_t_b);
    along.depth = scale3(sigma, v);
    along.divisor = R(1.0);
    if (SHORT_LIGHTS && light.is_short != 0u) {
        float huge = 3e38f;
        float low = fmin(light.channel_r > 0.0f ? medium.sigma_t_r : huge,
                         fmin(light.channel_g > 0.0f ? medium.sigma_t_g : huge, light.channel_b > 0.0f ? medium.sigma_t_b : huge));
        along.depth = make_real3((real)fmax(medium.sigma_t_r - low, 0.0f) * v, (real)fmax(medium.sigma_t_g - low, 0.0f) * v,
                                 (real)fmax(medium.sigma_t_b - low, 0.0f) * v);
        real3 survive = transmittance3(along.depth);
        along.divisor = fma((real)light.channel_r, survive.x, fma((real)light.channel_g, survive.y, (real)light.channel_b * survive.z));
    }
    return along;
}

/// Marginal over the light, conditional over the eye segment, everything but the transmittance of the connection (kernels/README.md).
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, Random2 xi)
{
    real3 start = make_real3((real)light.origin_x, (real)light.origin_y, (real)light.origin_z);
    real3 b = make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z);
    real3 q = sub3(start, eye.origin);
    RodSample rod = sample_rod(q, eye.direction, b, (real)light.length, xi.first);
    real3 p = along3(q, rod.v, b);
    PhaseWarp warp = {xi.second, R(1.0)};
    if (ANISOTROPIC) {
        if (SAMPLER == SAMPLER_PAPER) warp = sample_phase_product(p, eye.direction, eye.length, b, eye_medium.g, (real)medium.g, xi.second);
    }
    AngleSample angle = sample_equiangular(p, eye.direction, eye.length, warp.x);
    real weight = pair_weight(rod, angle) / warp.density;

    real3 d = along3(p, -angle.u, eye.direction);                 // from the eye segment to the light
    Connection c;
    c.floored = rod.floor_ratio > R(1.0);
    c.from = along3(eye.origin, angle.u, eye.direction);
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_isotropic() * phase_isotropic();
    if (ANISOTROPIC) {
        real3 towards_eye = scale3(d, R(-1.0) / fmax(c.length, R(1e-30)));  // length 0: direction (0, 0, 0), whose phase is finite
        phase = phase_henyey_greenstein(b, towards_eye, (real)medium.g) *
                phase_henyey_greenstein(towards_eye, scale3(eye.direction, R(-1.0)), eye_medium.g);
    }
    AlongLight along = along_light(light, medium, rod.v);
    real3 depth = make_real3(fma(eye_medium.sigma_t.x, angle.u, along.depth.x), fma(eye_medium.sigma_t.y, angle.u, along.depth.y),
                             fma(eye_medium.sigma_t.z, angle.u, along.depth.z));
    real3 scattering = mul3(eye_medium.sigma_s, make_real3((real)(medium.sigma_s_r * light.flux_r), (real)(medium.sigma_s_g * light.flux_g),
                                                           (real)(medium.sigma_s_b * light.flux_b)));
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(depth)), weight * phase / along.divisor);
    return c;
}

/// The same for a point on a diffuse surface: cosine-weighted density over the light in closed form (kernels/README.md).
PURE Connection connect_point(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, Random2 xi)
{
    real3 start = make_real3((real)light.origin_x, (real)light.origin_y, (real)light.origin_z);
    real3 b = make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z);
    real3 p = sub3(start, eye.position);
    SurfaceRodSample rod = sample_surface_rod(p, b, (real)light.length, eye.normal, xi.first);
    real3 d = along3(p, rod.v, b);
    Connection c;
    c.floored = rod.v < R(0.0);                                   // never: this density has no floor
    c.from = eye.position;
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_isotropic();
    if (ANISOTROPIC) phase = phase_henyey_greenstein(b, scale3(d, R(-1.0) / fmax(c.length, R(1e-30))), (real)medium.g);
    AlongLight along = along_light(light, medium, rod.v);
    real weight = select(R(0.0), rod.weight, dot3(d, eye.facing) > R(0.0));
    real3 scattering = make_real3((real)(medium.sigma_s_r * light.flux_r), (real)(medium.sigma_s_g * light.flux_g), (real)(medium.sigma_s_b * light.flux_b));
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(along.depth)), weight * phase / along.divisor);
    return c;
}

#endif
