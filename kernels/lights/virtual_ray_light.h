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

/// Where a connection runs and what the choice is worth: distances along light and eye segment, 1 / (w^2 pdf).
typedef struct {
    real v, u, weight;
    mask floored;  ///< the floor on the pair's distance was active (eq. 7)
} Places;

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

PURE real3 light_origin(VirtualRayLight light) { return make_real3((real)light.origin_x, (real)light.origin_y, (real)light.origin_z); }
PURE real3 light_direction(VirtualRayLight light) { return make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z); }

// An eye segment's connection in three steps. Each is short enough for a processor to overlap it with the same step of the next pair, which all three
// together are not; so the stages take a batch of pairs through one step before the next (kernels/stages/connection.h).

/// Step 1, the marginal: where on the light.
PURE RodSample place_on_light(EyeSegmentLanes eye, VirtualRayLight light, real xi)
{
    return sample_rod(sub3(light_origin(light), eye.origin), eye.direction, light_direction(light), (real)light.length, xi);
}

/// Step 2, the conditional: where on the eye segment, and the weight of both choices.
PURE Places place_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, RodSample rod, real xi)
{
    real3 b = light_direction(light), p = along3(sub3(light_origin(light), eye.origin), rod.v, b);
    PhaseWarp warp = {xi, R(1.0)};
    if (ANISOTROPIC) {
        if (SAMPLER == SAMPLER_PAPER) warp = sample_phase_product(p, eye.direction, eye.length, b, eye_medium.g, (real)medium.g, xi);
    }
    AngleSample angle = sample_equiangular(p, eye.direction, eye.length, warp.x);
    Places places;
    places.v = rod.v, places.u = angle.u;
    places.weight = pair_weight(rod, angle) / warp.density;
    places.floored = rod.floor_ratio > R(1.0);
    return places;
}

/// Step 3: everything but the transmittance of the connection (kernels/README.md).
PURE Connection connect_segment_at(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, Places at)
{
    real3 b = light_direction(light), q = sub3(light_origin(light), eye.origin), p = along3(q, at.v, b);
    real3 d = along3(p, -at.u, eye.direction);                    // from the eye segment to the light
    Connection c;
    c.floored = at.floored;
    c.from = along3(eye.origin, at.u, eye.direction);
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_isotropic() * phase_isotropic();
    if (ANISOTROPIC) {
        real3 towards_eye = scale3(d, R(-1.0) / fmax(c.length, R(1e-30)));  // length 0: direction (0, 0, 0), whose phase is finite
        phase = phase_henyey_greenstein(b, towards_eye, (real)medium.g) *
                phase_henyey_greenstein(towards_eye, scale3(eye.direction, R(-1.0)), eye_medium.g);
    }
    AlongLight along = along_light(light, medium, at.v);
    real3 depth = make_real3(fma(eye_medium.sigma_t.x, at.u, along.depth.x), fma(eye_medium.sigma_t.y, at.u, along.depth.y),
                             fma(eye_medium.sigma_t.z, at.u, along.depth.z));
    real3 scattering = mul3(eye_medium.sigma_s, make_real3((real)(medium.sigma_s_r * light.flux_r), (real)(medium.sigma_s_g * light.flux_g),
                                                           (real)(medium.sigma_s_b * light.flux_b)));
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(depth)), at.weight * phase / along.divisor);
    return c;
}

/// The three steps for one pair.
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, Random2 xi)
{
    RodSample rod = place_on_light(eye, light, xi.first);
    return connect_segment_at(eye, eye_medium, light, medium, place_on_segment(eye, eye_medium, light, medium, rod, xi.second));
}

/// A point on a diffuse surface, in two steps. The first: cosine-weighted density over the light in closed form (kernels/README.md).
PURE SurfaceRodSample place_on_light_from_point(EyePointLanes eye, VirtualRayLight light, real xi)
{
    return sample_surface_rod(sub3(light_origin(light), eye.position), light_direction(light), (real)light.length, eye.normal, xi);
}

/// The second: everything but the transmittance of the connection.
PURE Connection connect_point_at(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, SurfaceRodSample rod)
{
    real3 b = light_direction(light), d = along3(sub3(light_origin(light), eye.position), rod.v, b);
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

/// The two steps for one pair.
PURE Connection connect_point(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, Random2 xi)
{
    return connect_point_at(eye, light, medium, place_on_light_from_point(eye, light, xi.first));
}

#endif
