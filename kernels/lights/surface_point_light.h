/// A virtual point light on a surface [Keller 1997]: a light path's arrival at a surface that reflects diffusely, from where the light goes on to the surface's side. This file is what every
/// stage needs to know of it: the record `Light`, and one sample of its connection to an eye segment and to an eye point (kernels/README.md, section 17).
#ifndef SURFACE_POINT_LIGHT_H
#define SURFACE_POINT_LIGHT_H

#include "kernels/math/light_estimate.h"
#include "kernels/math/point_light.h"

typedef struct {
    float position_x, position_y, position_z;  ///< already moved off the surface
    uint medium;                               ///< in front of the surface: its number in the table of media, whose last stands for vacuum
    float facing_x, facing_y, facing_z;        ///< geometric normal of the side at which the light arrived, unit
    uint depth;                                ///< scattering vertices before this one
    float power_r, power_g, power_b;           ///< W per steradian and cosine: what arrives times reflectance / pi, with the shading normal's part of the arrival (eq. 59a)
    uint padding_0;
    float normal_x, normal_y, normal_z;        ///< shading normal of that side, unit
    uint padding_1;
} SurfacePointLight;
LAYOUT(SurfacePointLight, 64)

typedef SurfacePointLight Light;

enum { LIGHT_IS_LINE = 0, LIGHT_ON_SURFACE = 1 };
PURE uint light_medium(SurfacePointLight light) { return light.medium; }
PURE uint light_depth(SurfacePointLight light) { return light.depth; }
PURE real3 light_origin(SurfacePointLight light) { return make_real3((real)light.position_x, (real)light.position_y, (real)light.position_z); }
PURE real3 light_direction(SurfacePointLight light) { return make_real3((real)light.facing_x, (real)light.facing_y, (real)light.facing_z); }
PURE float light_length(SurfacePointLight light) { return 0.0f; }
PURE uint light_is_even(SurfacePointLight light) { return 1u; }
PURE real3 surface_light_power(SurfacePointLight light) { return make_real3((real)light.power_r, (real)light.power_g, (real)light.power_b); }

/// The cosine at the geometric normal, because the light is spread over the area of the true surface; 0 where either normal says that the eye is behind. d: from the eye to the light, of that
/// length. Length 0: 0.
PURE real cosine_at_light(SurfacePointLight light, real3 d, real length)
{
    real over_surface = -dot3(d, light_direction(light)), over_shading = -dot3(d, make_real3((real)light.normal_x, (real)light.normal_y, (real)light.normal_z));
    return select(R(0.0), over_surface / fmax(length, R(1e-30)), (over_surface > R(0.0)) & (over_shading > R(0.0)));
}

// To an eye segment: only the place on it is drawn, by the second random number.

typedef PointPlace PlaceOnLight;
PURE PlaceOnLight place_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, real xi) { return point_place(); }
PURE PlaceOnLight find_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, real v) { return point_place(); }

/// What the density on the eye segment follows besides the angle: phase function and transmittance of the eye's side; the light sends evenly.
PURE GuideMedia surface_light_guide(MediumLanes eye_medium, MediumRecord medium)
{
    GuideMedia guide = {eye_medium.g, R(0.0), eye_medium.sigma_t.x, R(0.0), (real)medium.sigma_t_r};
    if (COLOURED) {
        guide.sigma_eye = fmin(guide.sigma_eye, fmin(eye_medium.sigma_t.y, eye_medium.sigma_t.z));
        guide.sigma_leg = (real)fmin(medium.sigma_t_r, fmin(medium.sigma_t_g, medium.sigma_t_b));
    }
    if (HETEROGENEOUS) guide.sigma_eye = guide.sigma_leg = R(0.0);
    return guide;
}
PURE PhaseRange even_range(void)
{
    PhaseRange range = {0u, 0u, 0.0f};
    return range;
}

PURE Places place_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real xi)
{
    real3 p = sub3(light_origin(light), eye.origin);
    PhaseWarp warp = {xi, R(1.0)};
    if (SAMPLER_WARPS)
        warp = sample_lobe_product(p, eye.direction, eye.length, light_direction(light), surface_light_guide(eye_medium, medium), eye_medium.phase, even_range(), tables, warp_shape(), xi);
    return place_beside_point(sample_equiangular(p, eye.direction, eye.length, warp.x), warp.density);
}
PURE Places find_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real u)
{
    real3 p = sub3(light_origin(light), eye.origin);
    real density = R(1.0);
    if (SAMPLER_WARPS)
        density = pdf_lobe_product(p, eye.direction, eye.length, light_direction(light), surface_light_guide(eye_medium, medium), eye_medium.phase, even_range(), tables, warp_shape(),
                                   invert_equiangular(p, eye.direction, eye.length, u));
    return place_beside_point(angle_at(p, eye.direction, eye.length, u), density);
}

PURE Places share_places(EyeSegmentLanes eye, SurfacePointLight light, Places at, real other, real share) { return share_beside_point(eye, light_origin(light), at, other, share); }

/// Phase function on the eye segment for light that comes from the far end of d, which has that length.
PURE real phase_on_eye(EyeSegmentLanes eye, MediumLanes eye_medium, PhaseTables tables, real3 d, real length)
{
    if (!ANISOTROPIC) return phase_isotropic();
    return phase_of_lanes(eye_medium.phase, tables, eye_medium.g, scale3(d, R(-1.0) / fmax(length, R(1e-30))), scale3(eye.direction, R(-1.0)));
}

/// Everything but the transmittance of the connection. on_eye: what lies along the eye segment up to the place.
PURE Connection connect_segment_at(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, PhaseTables tables, Places at,
                                    Matter on_eye, Matter on_light)
{
    real3 d = along3(sub3(light_origin(light), eye.origin), -at.u, eye.direction);            // from the eye segment to the light
    Connection c;
    c.floored = at.floored;
    c.from = along3(eye.origin, at.u, eye.direction);
    c.to = add3(c.from, d);
    c.length = length3(d);
    real value = at.weight * cosine_at_light(light, d, c.length) * phase_on_eye(eye, eye_medium, tables, d, c.length);
    real3 scattering = mul3(eye_medium.sigma_s, surface_light_power(light));
    if (HETEROGENEOUS) scattering = mul3(scattering, on_eye.scattering);
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(mul3(eye_medium.sigma_t, on_eye.path))), value);
    return c;
}
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceOnLight on_light = place_on_light(eye, eye_medium, light, medium, xi.first);
    Places at = place_on_segment(eye, eye_medium, light, medium, on_light, tables, xi.second);
    return connect_segment_at(eye, eye_medium, light, medium, tables, at, even_matter(at.u), even_matter(R(0.0)));
}

// To a surface point nothing is drawn.

typedef PointFromPoint PlaceFromPoint;
PURE PlaceFromPoint place_on_light_from_point(EyePointLanes eye, SurfacePointLight light, real xi) { return place_from_point(eye, light_origin(light)); }
PURE PlaceFromPoint find_on_light_from_point(EyePointLanes eye, SurfacePointLight light, real v) { return place_on_light_from_point(eye, light, v); }
PURE PlaceFromPoint share_place(EyePointLanes eye, SurfacePointLight light, PlaceFromPoint at, real other, real share) { return at; }

PURE Connection connect_point_at(EyePointLanes eye, SurfacePointLight light, MediumRecord medium, PhaseTables tables, PlaceFromPoint at, Matter on_light)
{
    real3 d = sub3(light_origin(light), eye.position);
    Connection c;
    c.floored = at.floored;
    c.from = eye.position;
    c.to = add3(c.from, d);
    c.length = length3(d);
    real value = at.weight * cosine_at_light(light, d, c.length);
    c.radiance = scale3(mul3(surface_light_power(light), eye.throughput), select(R(0.0), value, dot3(d, eye.facing) > R(0.0)));
    return c;
}
PURE Connection connect_point(EyePointLanes eye, SurfacePointLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    return connect_point_at(eye, light, medium, tables, place_on_light_from_point(eye, light, xi.first), even_matter(R(0.0)));
}

// What lights are chosen by (kernels/README.md, section 16).

/// density: of the medium around, relative to its coefficients.
PURE EstimateMedia surface_light_media(SurfacePointLight light, MediumRecord medium, real3 colour, real g_eye, real density)
{
    real3 sigma_t = make_real3((real)medium.sigma_t_r * density, (real)medium.sigma_t_g * density, (real)medium.sigma_t_b * density);
    EstimateMedia m = {mul3(colour, surface_light_power(light)), sigma_t, scale3(sigma_t, R(0.0)), sigma_t, g_eye, R(0.0), ANISOTROPIC, COLOURED | COLOURED_GRIDS};
    return m;
}

/// Eyes of a block see the light under other cosines: a share of the estimate does not ask for it.
PURE real rough_cosine(SurfacePointLight light, real3 d, real over_length) { return ESTIMATE_ANY_NORMAL + fmax(-dot3(d, light_direction(light)) * over_length, R(0.0)); }

PURE real light_power(SurfacePointLight light, MediumRecord medium) { return (real)light.power_r + (real)light.power_g + (real)light.power_b; }

/// R times the mean over three angles of colour x cosine at the light x phase function x transmittance, summed over channels, times 4 pi.
PURE real estimate_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, SurfacePointLight light, MediumRecord medium, real density)
{
    EstimateMedia m = surface_light_media(light, medium, mul3(eye.throughput, eye_medium.sigma_s), eye_medium.g, density);
    if (MANY_MEDIA) m.eye = eye_medium.sigma_t;
    real3 p = sub3(light_origin(light), eye.origin);
    real sum = R(0.0), over_distance = R(0.0);
    for (int i = 0; i < ESTIMATE_ANGLES; ++i) {
        AngleSample at = sample_equiangular(p, eye.direction, eye.length, (real)(((float)i + 0.5f) / (float)ESTIMATE_ANGLES));
        real3 d = along3(p, -at.u, eye.direction);
        real w = length3(d), over = R(1.0) / fmax(w, REAL_SMALLEST);
        real value = rough_cosine(light, d, over) * colour_left(m, at.u, R(0.0), w);
        if (m.lobes) value = value * guide_phase(m.g_eye, R(0.0), dot3(d, eye.direction) * over, R(0.0));
        sum = sum + value, over_distance = at.angle_over_distance;
    }
    return over_distance * sum * (real)(1.0f / (float)ESTIMATE_ANGLES);
}

/// Colour x both cosines x transmittance / w^2.
PURE real estimate_to_point(EyePointLanes eye, SurfacePointLight light, MediumRecord medium, real density)
{
    EstimateMedia m = surface_light_media(light, medium, eye.throughput, R(0.0), density);
    real3 d = sub3(light_origin(light), eye.position);
    real w = length3(d), over = R(1.0) / fmax(w, REAL_SMALLEST);
    real value = (ESTIMATE_ANY_NORMAL + fmax(dot3(eye.normal, d) * over, R(0.0))) * rough_cosine(light, d, over) * colour_left(m, R(0.0), R(0.0), w);
    return value * over * over;
}

#endif
