/// A virtual point light: a collision of a light path with a medium, from where the light goes on in all directions as the phase function says. This file is
/// what every stage needs to know of it: the record `Light`, and one sample of its connection to an eye segment and to an eye point (kernels/README.md, section 17).
#ifndef VIRTUAL_POINT_LIGHT_H
#define VIRTUAL_POINT_LIGHT_H

#include "kernels/math/light_estimate.h"
#include "kernels/math/point_light.h"

typedef struct {
    float position_x, position_y, position_z;
    uint medium;
    float direction_x, direction_y, direction_z;  ///< unit, of the light before it is scattered here
    uint depth;                                   ///< scattering vertices before this one
    float power_r, power_g, power_b;              ///< W that are scattered here; what the medium is at the point is in it
    uint padding;
} VirtualPointLight;
LAYOUT(VirtualPointLight, 48)

typedef VirtualPointLight Light;

enum { LIGHT_IS_LINE = 0, LIGHT_ON_SURFACE = 0 };
PURE uint light_medium(VirtualPointLight light) { return light.medium; }
PURE uint light_depth(VirtualPointLight light) { return light.depth; }
PURE real3 light_origin(VirtualPointLight light) { return make_real3((real)light.position_x, (real)light.position_y, (real)light.position_z); }
PURE real3 light_direction(VirtualPointLight light) { return make_real3((real)light.direction_x, (real)light.direction_y, (real)light.direction_z); }
PURE float light_length(VirtualPointLight light) { return 0.0f; }
PURE uint light_is_even(VirtualPointLight light) { return 1u; }
PURE real3 point_power(VirtualPointLight light) { return make_real3((real)light.power_r, (real)light.power_g, (real)light.power_b); }

// To an eye segment: only the place on it is drawn, by the second random number.

typedef PointPlace PlaceOnLight;
PURE PlaceOnLight place_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, real xi) { return point_place(); }
PURE PlaceOnLight find_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, real v) { return point_place(); }

/// What the density on the eye segment follows besides the angle: as for rays, with nothing along the light.
PURE GuideMedia point_guide_media(MediumLanes eye_medium, MediumRecord medium)
{
    GuideMedia guide = {eye_medium.g, (real)medium.g, eye_medium.sigma_t.x, R(0.0), (real)medium.sigma_t_r};
    if (COLOURED) {
        guide.sigma_eye = fmin(guide.sigma_eye, fmin(eye_medium.sigma_t.y, eye_medium.sigma_t.z));
        guide.sigma_leg = (real)fmin(medium.sigma_t_r, fmin(medium.sigma_t_g, medium.sigma_t_b));
    }
    if (HETEROGENEOUS && medium.density_grid != NO_GRID) guide.sigma_eye = guide.sigma_leg = R(0.0);
    return guide;
}

PURE Places place_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real xi)
{
    real3 p = sub3(light_origin(light), eye.origin);
    PhaseWarp warp = {xi, R(1.0)};
    if (SAMPLER_WARPS)
        warp = sample_lobe_product(p, eye.direction, eye.length, light_direction(light), point_guide_media(eye_medium, medium), eye_medium.phase, phase_range(medium), tables,
                                   warp_shape(), xi);
    return place_beside_point(sample_equiangular(p, eye.direction, eye.length, warp.x), warp.density);
}
PURE Places find_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real u)
{
    real3 p = sub3(light_origin(light), eye.origin);
    real density = R(1.0);
    if (SAMPLER_WARPS)
        density = pdf_lobe_product(p, eye.direction, eye.length, light_direction(light), point_guide_media(eye_medium, medium), eye_medium.phase, phase_range(medium), tables,
                                   warp_shape(), invert_equiangular(p, eye.direction, eye.length, u));
    return place_beside_point(angle_at(p, eye.direction, eye.length, u), density);
}

PURE Places share_places(EyeSegmentLanes eye, VirtualPointLight light, Places at, real other, real share) { return share_beside_point(eye, light_origin(light), at, other, share); }

/// Everything but the transmittance of the connection. on_eye: what lies along the eye segment up to the place.
PURE Connection connect_segment_at(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, PhaseTables tables, Places at,
                                    Matter on_eye, Matter on_light)
{
    real3 d = along3(sub3(light_origin(light), eye.origin), -at.u, eye.direction);            // from the eye segment to the light
    Connection c;
    c.floored = at.floored;
    c.from = along3(eye.origin, at.u, eye.direction);
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_of_both(eye, eye_medium, light_direction(light), medium, tables, d, c.length);
    real3 scattering = mul3(eye_medium.sigma_s, point_power(light));
    if (HETEROGENEOUS) scattering = mul3(scattering, on_eye.scattering);
    c.radiance = scale3(mul3(mul3(scattering, eye.throughput), transmittance3(mul3(eye_medium.sigma_t, on_eye.path))), at.weight * phase);
    return c;
}
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceOnLight on_light = place_on_light(eye, eye_medium, light, medium, xi.first);
    Places at = place_on_segment(eye, eye_medium, light, medium, on_light, tables, xi.second);
    return connect_segment_at(eye, eye_medium, light, medium, tables, at, even_matter(at.u), even_matter(R(0.0)));
}

// To a surface point nothing is drawn.

typedef PointFromPoint PlaceFromPoint;
PURE PlaceFromPoint place_on_light_from_point(EyePointLanes eye, VirtualPointLight light, real xi) { return place_from_point(eye, light_origin(light)); }
PURE PlaceFromPoint find_on_light_from_point(EyePointLanes eye, VirtualPointLight light, real v) { return place_on_light_from_point(eye, light, v); }
PURE PlaceFromPoint share_place(EyePointLanes eye, VirtualPointLight light, PlaceFromPoint at, real other, real share) { return at; }

PURE Connection connect_point_at(EyePointLanes eye, VirtualPointLight light, MediumRecord medium, PhaseTables tables, PlaceFromPoint at, Matter on_light)
{
    real3 d = sub3(light_origin(light), eye.position);
    Connection c;
    c.floored = at.floored;
    c.from = eye.position;
    c.to = add3(c.from, d);
    c.length = length3(d);
    real phase = phase_of_light(light_direction(light), medium, tables, d, c.length);
    c.radiance = scale3(mul3(point_power(light), eye.throughput), select(R(0.0), at.weight * phase, dot3(d, eye.facing) > R(0.0)));
    return c;
}
PURE Connection connect_point(EyePointLanes eye, VirtualPointLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    return connect_point_at(eye, light, medium, tables, place_on_light_from_point(eye, light, xi.first), even_matter(R(0.0)));
}

// What lights are chosen by (kernels/README.md, section 16).

/// density: of the medium around, relative to its coefficients.
PURE EstimateMedia point_estimate_media(VirtualPointLight light, MediumRecord medium, real3 colour, real g_eye, real density)
{
    real3 sigma_t = make_real3((real)medium.sigma_t_r * density, (real)medium.sigma_t_g * density, (real)medium.sigma_t_b * density);
    EstimateMedia m = {mul3(colour, point_power(light)), sigma_t, scale3(sigma_t, R(0.0)), sigma_t, g_eye, (real)medium.g, ANISOTROPIC, COLOURED | COLOURED_GRIDS};
    return m;
}

PURE real light_power(VirtualPointLight light, MediumRecord medium) { return (real)light.power_r + (real)light.power_g + (real)light.power_b; }

/// R times the mean over three angles of colour x phase functions x transmittance, summed over channels, times (4 pi)^2.
PURE real estimate_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualPointLight light, MediumRecord medium, real density)
{
    EstimateMedia m = point_estimate_media(light, medium, mul3(eye.throughput, eye_medium.sigma_s), eye_medium.g, density);
    if (MANY_MEDIA) m.eye = eye_medium.sigma_t;
    real3 p = sub3(light_origin(light), eye.origin), b = light_direction(light);
    real sum = R(0.0), over_distance = R(0.0);
    for (int i = 0; i < ESTIMATE_ANGLES; ++i) {
        AngleSample at = sample_equiangular(p, eye.direction, eye.length, (real)(((float)i + 0.5f) / (float)ESTIMATE_ANGLES));
        real3 d = along3(p, -at.u, eye.direction);
        real w = length3(d), over = R(1.0) / fmax(w, REAL_SMALLEST);
        real value = colour_left(m, at.u, R(0.0), w);
        if (m.lobes) value = value * guide_phase(m.g_eye, m.g_light, dot3(d, eye.direction) * over, -dot3(b, d) * over);
        sum = sum + value, over_distance = at.angle_over_distance;
    }
    return over_distance * sum * (real)(1.0f / (float)ESTIMATE_ANGLES);
}

/// Colour x cosine x phase function x transmittance / w^2, times 4 pi.
PURE real estimate_to_point(EyePointLanes eye, VirtualPointLight light, MediumRecord medium, real density)
{
    EstimateMedia m = point_estimate_media(light, medium, eye.throughput, R(0.0), density);
    real3 d = sub3(light_origin(light), eye.position);
    real w = length3(d), over = R(1.0) / fmax(w, REAL_SMALLEST);
    real value = (ESTIMATE_ANY_NORMAL + fmax(dot3(eye.normal, d) * over, R(0.0))) * colour_left(m, R(0.0), R(0.0), w);
    if (m.lobes) value = value * guide_phase(R(0.0), m.g_light, R(1.0), -dot3(light_direction(light), d) * over);
    return value * over * over;
}

#endif
