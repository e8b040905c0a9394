/// A piece of a light path inside one medium that shines from everywhere along it: the record, and one sample of its connection to an eye segment and to an eye
/// point. Lights that are rays (kernels/lights) say here what they send.
#ifndef RAY_LIGHT_H
#define RAY_LIGHT_H

#include "kernels/math/eye_and_light.h"
#include "kernels/math/rod_estimate.h"
#include "kernels/math/surface_rod.h"

typedef struct {
    float origin_x, origin_y, origin_z, length;
    float direction_x, direction_y, direction_z;  ///< unit, direction of travel
    uint medium;
    float flux_r, flux_g, flux_b;  ///< W: emitted power x throughput up to the origin / number of paths; no transmittance along the light
    uint depth;                    ///< scattering vertices before the origin
    float channel_r, channel_g, channel_b;  ///< short: probability that channel c chose the distance x its transmittance up to the origin; long: unused
    uint is_short;                          ///< 1: ends at its sampled collision and is divided by the probability of reaching v
} RayLight;
LAYOUT(RayLight, 64)

/// Optical depths up to a point beyond the least of a channel that can have been chosen; 0 for channels that are less and cannot.
PURE real3 beyond_least(RayLight light, MediumRecord medium, real3 path)
{
    if (COLOURED_GRIDS) {
        real3 sigma = make_real3((real)medium.sigma_t_r, (real)medium.sigma_t_g, (real)medium.sigma_t_b), depth = mul3(sigma, path);
        real low = light.channel_r > 0.0f ? depth.x : R(3e38), low_sigma = sigma.x, low_path = path.x;
        mask green = (light.channel_g > 0.0f ? depth.y : R(3e38)) < low;
        low = select(low, depth.y, green), low_sigma = select(low_sigma, sigma.y, green), low_path = select(low_path, path.y, green);
        mask blue = (light.channel_b > 0.0f ? depth.z : R(3e38)) < low;
        low_sigma = select(low_sigma, sigma.z, blue), low_path = select(low_path, path.z, blue);
        return make_real3(fmax(difference_of_products(sigma.x, path.x, low_sigma, low_path), R(0.0)),
                          fmax(difference_of_products(sigma.y, path.y, low_sigma, low_path), R(0.0)),
                          fmax(difference_of_products(sigma.z, path.z, low_sigma, low_path), R(0.0)));
    }
    float huge = 3e38f;
    float low = fmin(light.channel_r > 0.0f ? medium.sigma_t_r : huge,
                     fmin(light.channel_g > 0.0f ? medium.sigma_t_g : huge, light.channel_b > 0.0f ? medium.sigma_t_b : huge));
    return make_real3((real)fmax(medium.sigma_t_r - low, 0.0f) * path.x, (real)fmax(medium.sigma_t_g - low, 0.0f) * path.x, (real)fmax(medium.sigma_t_b - low, 0.0f) * path.x);
}

/// Exponents (to be negated) and divisor of the transmittance along a light up to a point: long lights transmit exp(-depth) and divide by 1; short ones
/// divide by the probability that the sampled distance is beyond the point, sum_j channel_j exp(-depth_j). Both are taken relative to the smallest
/// depth of a channel that can have been chosen, so that neither underflows alone. `path`: what the light passed up to there (Matter::path).
typedef struct {
    real3 depth;
    real divisor;
} AlongLight;
PURE AlongLight along_light(RayLight light, MediumRecord medium, real3 path)
{
    AlongLight along;
    along.depth = mul3(make_real3((real)medium.sigma_t_r, (real)medium.sigma_t_g, (real)medium.sigma_t_b), path);
    along.divisor = R(1.0);
    if (SHORT_LIGHTS && light.is_short != 0u) {
        along.depth = beyond_least(light, medium, path);
        real3 survive = transmittance3(along.depth);
        along.divisor = fma((real)light.channel_r, survive.x, fma((real)light.channel_g, survive.y, (real)light.channel_b * survive.z));
    }
    return along;
}

PURE real3 ray_origin(RayLight light) { return make_real3((real)light.origin_x, (real)light.origin_y, (real)light.origin_z); }
PURE real3 ray_direction(RayLight light) { return make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z); }
PURE real3 scattered_flux(RayLight light, MediumRecord medium)
{
    return make_real3((real)(medium.sigma_s_r * light.flux_r), (real)(medium.sigma_s_g * light.flux_g), (real)(medium.sigma_s_b * light.flux_b));
}

// An eye segment's connection in three steps. Each is short enough for a processor to overlap it with the same step of the next pair, which all three
// together are not; so the stages take a batch of pairs through one step before the next (kernels/stages/connection.h).

/// What the samplers follow: the least extinction of the three channels, so that no channel's light is sampled too rarely far away; along short lights
/// none, because what they lose is what their density divides by.
PURE GuideMedia ray_guide_media(MediumLanes eye_medium, RayLight light, MediumRecord medium)
{
    GuideMedia guide;
    guide.g_eye = eye_medium.g, guide.g_light = (real)medium.g;
    guide.sigma_eye = eye_medium.sigma_t.x, guide.sigma_leg = (real)medium.sigma_t_r;
    if (COLOURED) {
        guide.sigma_eye = fmin(guide.sigma_eye, fmin(eye_medium.sigma_t.y, eye_medium.sigma_t.z));
        guide.sigma_leg = (real)fmin(medium.sigma_t_r, fmin(medium.sigma_t_g, medium.sigma_t_b));
    }
    if (HETEROGENEOUS && medium.density_grid != NO_GRID) guide.sigma_eye = guide.sigma_leg = R(0.0);  // where matter is, other densities know
    guide.sigma_light = SHORT_LIGHTS && light.is_short != 0u ? R(0.0) : guide.sigma_leg;
    return guide;
}

/// Step 1, the marginal: where on the light.
PURE RodSample place_on_ray(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, real xi)
{
    real3 q = sub3(ray_origin(light), eye.origin), b = ray_direction(light);
    if (!SAMPLER_TABULATES) return sample_rod(q, eye.direction, b, (real)light.length, xi);
    return sample_rod_table(q, eye.direction, b, (real)light.length, eye.length, ray_guide_media(eye_medium, light, medium), table_shape(), xi);
}

/// Step 2, the conditional: where on the eye segment, and the weight of both choices.
PURE Places place_beside_ray(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, RodSample rod, PhaseTables tables,
                              real xi)
{
    real3 b = ray_direction(light), p = along3(sub3(ray_origin(light), eye.origin), rod.v, b);
    PhaseWarp warp = {xi, R(1.0)};
    if (SAMPLER_WARPS)
        warp = sample_lobe_product(p, eye.direction, eye.length, b, ray_guide_media(eye_medium, light, medium), eye_medium.phase, phase_range(medium), tables, warp_shape(), xi);
    AngleSample angle = sample_equiangular(p, eye.direction, eye.length, warp.x);
    Places places;
    places.v = rod.v, places.u = angle.u;
    places.weight = pair_weight(rod, angle) / warp.density;
    places.floored = rod.floor_ratio > R(1.0);
    return places;
}

/// Steps 1 and 2 for places that another density has drawn: the weight that the two would have given them.
PURE RodSample find_on_ray(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, real v)
{
    real3 q = sub3(ray_origin(light), eye.origin), b = ray_direction(light);
    if (!SAMPLER_TABULATES) return rod_at(q, eye.direction, b, (real)light.length, v);
    return rod_table_at(q, eye.direction, b, (real)light.length, eye.length, ray_guide_media(eye_medium, light, medium), table_shape(), v);
}
PURE Places find_beside_ray(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, RodSample rod, PhaseTables tables, real u)
{
    real3 b = ray_direction(light), p = along3(sub3(ray_origin(light), eye.origin), rod.v, b);
    real density = R(1.0);
    if (SAMPLER_WARPS)
        density = pdf_lobe_product(p, eye.direction, eye.length, b, ray_guide_media(eye_medium, light, medium), eye_medium.phase, phase_range(medium), tables, warp_shape(),
                                   invert_equiangular(p, eye.direction, eye.length, u));
    Places places;
    places.v = rod.v, places.u = u;
    places.weight = pair_weight(rod, angle_at(p, eye.direction, eye.length, u)) / density;
    places.floored = rod.floor_ratio > R(1.0);
    return places;
}

/// The places with the weight that they have when with the chance `share` they are drawn with density `other`, per area of u and v, instead.
PURE Places share_ray_places(EyeSegmentLanes eye, RayLight light, Places at, real other, real share)
{
    real3 d = along3(along3(sub3(ray_origin(light), eye.origin), at.v, ray_direction(light)), -at.u, eye.direction);
    at.weight = shared_weight(at.weight, other * dot3(d, d), share);   // weight = 1 / (w^2 pdf)
    return at;
}

/// Step 3: everything but the transmittance of the connection (kernels/README.md). on_eye, on_light: what lies along both up to the places.
PURE Connection connect_ray_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, PhaseTables tables, Places at,
                                    Matter on_eye, Matter on_light)
{
    real3 b = ray_direction(light), q = sub3(ray_origin(light), eye.origin), p = along3(q, at.v, b);
    real3 d = along3(p, -at.u, eye.direction);                    // from the eye segment to the light
    Connection c;
    c.floored = at.floored;
    c.from = along3(eye.origin, at.u, eye.direction);
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_of_both(eye, eye_medium, b, medium, tables, d, c.length);
    AlongLight along = along_light(light, medium, on_light.path);
    real3 depth = make_real3(fma(eye_medium.sigma_t.x, on_eye.path.x, along.depth.x), fma(eye_medium.sigma_t.y, on_eye.path.y, along.depth.y),
                             fma(eye_medium.sigma_t.z, on_eye.path.z, along.depth.z));
    real3 scattering = mul3(eye_medium.sigma_s, scattered_flux(light, medium));
    if (HETEROGENEOUS) scattering = mul3(scattering, mul3(on_eye.scattering, on_light.scattering));
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(depth)), at.weight * phase / along.divisor);
    return c;
}

/// A point on a diffuse surface, in two steps. The first: cosine-weighted density over the light in closed form (kernels/README.md).
PURE SurfaceRodSample place_on_ray_from_point(EyePointLanes eye, RayLight light, real xi)
{
    return sample_surface_rod(sub3(ray_origin(light), eye.position), ray_direction(light), (real)light.length, eye.normal, xi);
}

/// The first for a place that another density has drawn.
PURE SurfaceRodSample find_on_ray_from_point(EyePointLanes eye, RayLight light, real v)
{
    return surface_rod_at(sub3(ray_origin(light), eye.position), ray_direction(light), (real)light.length, eye.normal, v);
}

/// The place with the weight that it has when with the chance `share` it is drawn with density `other`, per length of v, instead.
PURE SurfaceRodSample share_ray_place(EyePointLanes eye, RayLight light, SurfaceRodSample at, real other, real share)
{
    real3 d = along3(sub3(ray_origin(light), eye.position), at.v, ray_direction(light));
    real w2 = dot3(d, d), over = w2 * sqrt(w2), rise = dot3(eye.normal, d);                    // weight = rise / (over pdf)
    mask above = rise > R(0.0);
    at.weight = select(R(0.0), shared_weight(at.weight, other * over / select(R(1.0), rise, above), share), above);
    return at;
}

/// The second: everything but the transmittance of the connection.
PURE Connection connect_ray_to_point(EyePointLanes eye, RayLight light, MediumRecord medium, PhaseTables tables, SurfaceRodSample rod, Matter on_light)
{
    real3 b = ray_direction(light), d = along3(sub3(ray_origin(light), eye.position), rod.v, b);
    Connection c;
    c.floored = rod.v < R(0.0);                                   // never: this density has no floor
    c.from = eye.position;
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_of_light(b, medium, tables, d, c.length);
    AlongLight along = along_light(light, medium, on_light.path);
    real weight = select(R(0.0), rod.weight, dot3(d, eye.facing) > R(0.0));
    real3 scattering = HETEROGENEOUS ? mul3(scattered_flux(light, medium), on_light.scattering) : scattered_flux(light, medium);
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(along.depth)), weight * phase / along.divisor);
    return c;
}

// Which lights an eye is connected to (kernels/README.md, section 16).
/// What an eye that turns light into `colour` is estimated by. density: of the medium around, relative to its coefficients.
PURE EstimateMedia ray_estimate_media(RayLight light, MediumRecord medium, real3 colour, real g_eye, real density)
{
    real3 sigma_t = make_real3((real)medium.sigma_t_r * density, (real)medium.sigma_t_g * density, (real)medium.sigma_t_b * density);
    real lost = SHORT_LIGHTS && light.is_short != 0u ? R(0.0) : R(1.0);
    EstimateMedia m = {mul3(colour, scattered_flux(light, medium)), sigma_t, scale3(sigma_t, lost), sigma_t, g_eye, (real)medium.g, ANISOTROPIC, COLOURED | COLOURED_GRIDS};
    return m;
}

/// Power that the light scatters, summed over channels, without 4 pi: what a choice by power alone goes by.
PURE real ray_power(RayLight light, MediumRecord medium)
{
    return rod_power(ray_estimate_media(light, medium, make_real3(R(1.0), R(1.0), R(1.0)), R(0.0), R(1.0)), (real)light.length);
}

/// What an eye segment receives, roughly, summed over channels, up to a constant factor.
PURE real estimate_ray_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, RayLight light, MediumRecord medium, real density)
{
    EstimateMedia m = ray_estimate_media(light, medium, mul3(eye.throughput, eye_medium.sigma_s), eye_medium.g, density);
    if (MANY_MEDIA) m.eye = eye_medium.sigma_t;
    return rod_estimate(sub3(ray_origin(light), eye.origin), eye.direction, ray_direction(light), (real)light.length, eye.length, m);
}

/// What a surface point receives.
PURE real estimate_ray_to_point(EyePointLanes eye, RayLight light, MediumRecord medium, real density)
{
    return surface_rod_estimate(sub3(ray_origin(light), eye.position), ray_direction(light), (real)light.length, eye.normal,
                                ray_estimate_media(light, medium, eye.throughput, R(0.0), density));
}

#endif
