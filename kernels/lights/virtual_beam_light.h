/// A virtual beam light, after [Novak et al. 2012b]: a virtual ray light that is thick. What a place on it sends within the distance `radius` is spread so that no connection is
/// brighter than 9 / radius^2 where that of a ray is 1 / w^2 (kernels/README.md, section 18); biased, and less so the thinner it is. Places are drawn as on the ray.
#ifndef VIRTUAL_BEAM_LIGHT_H
#define VIRTUAL_BEAM_LIGHT_H

#include "kernels/math/ray_light.h"

typedef struct {
    RayLight ray;
    float radius;      ///< > 0
    uint padding_0, padding_1, padding_2;
} VirtualBeamLight;
LAYOUT(VirtualBeamLight, 80)

typedef VirtualBeamLight Light;

enum { LIGHT_IS_LINE = 1, LIGHT_ON_SURFACE = 0 };
PURE uint light_medium(VirtualBeamLight light) { return light.ray.medium; }
PURE uint light_depth(VirtualBeamLight light) { return light.ray.depth; }
PURE real3 light_origin(VirtualBeamLight light) { return ray_origin(light.ray); }
PURE real3 light_direction(VirtualBeamLight light) { return ray_direction(light.ray); }
PURE float light_length(VirtualBeamLight light) { return light.ray.length; }
PURE uint light_is_even(VirtualBeamLight light) { return SHORT_LIGHTS && light.ray.is_short != 0u ? 1u : 0u; }

/// w^2 times what takes the place of 1 / w^2 (eq. 60): 1 from the radius on, x^2 (9 - 8 x) at the share x of it.
PURE real beam_share(real w, float radius)
{
    real x = fmin(w / (real)radius, R(1.0));
    return x * x * fma(R(-8.0), x, R(9.0));
}
PURE Connection thickened(Connection c, float radius)
{
    c.radiance = scale3(c.radiance, beam_share(c.length, radius));
    return c;
}

typedef RodSample PlaceOnLight;
PURE PlaceOnLight place_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, real xi)
{
    return place_on_ray(eye, eye_medium, light.ray, medium, xi);
}
PURE Places place_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real xi)
{
    return place_beside_ray(eye, eye_medium, light.ray, medium, on_light, tables, xi);
}
PURE PlaceOnLight find_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, real v)
{
    return find_on_ray(eye, eye_medium, light.ray, medium, v);
}
PURE Places find_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real u)
{
    return find_beside_ray(eye, eye_medium, light.ray, medium, on_light, tables, u);
}
PURE Places share_places(EyeSegmentLanes eye, VirtualBeamLight light, Places at, real other, real share) { return share_ray_places(eye, light.ray, at, other, share); }
PURE Connection connect_segment_at(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, PhaseTables tables, Places at,
                                    Matter on_eye, Matter on_light)
{
    return thickened(connect_ray_to_segment(eye, eye_medium, light.ray, medium, tables, at, on_eye, on_light), light.radius);
}
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceOnLight on_light = place_on_light(eye, eye_medium, light, medium, xi.first);
    Places at = place_on_segment(eye, eye_medium, light, medium, on_light, tables, xi.second);
    return connect_segment_at(eye, eye_medium, light, medium, tables, at, even_matter(at.u), even_matter(at.v));
}

typedef SurfaceRodSample PlaceFromPoint;
PURE PlaceFromPoint place_on_light_from_point(EyePointLanes eye, VirtualBeamLight light, real xi) { return place_on_ray_from_point(eye, light.ray, xi); }
PURE PlaceFromPoint find_on_light_from_point(EyePointLanes eye, VirtualBeamLight light, real v) { return find_on_ray_from_point(eye, light.ray, v); }
PURE PlaceFromPoint share_place(EyePointLanes eye, VirtualBeamLight light, PlaceFromPoint at, real other, real share)
{
    return share_ray_place(eye, light.ray, at, other, share);
}
PURE Connection connect_point_at(EyePointLanes eye, VirtualBeamLight light, MediumRecord medium, PhaseTables tables, PlaceFromPoint at, Matter on_light)
{
    return thickened(connect_ray_to_point(eye, light.ray, medium, tables, at, on_light), light.radius);
}
PURE Connection connect_point(EyePointLanes eye, VirtualBeamLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceFromPoint at = place_on_light_from_point(eye, light, xi.first);
    return connect_point_at(eye, light, medium, tables, at, even_matter(at.v));
}

// What lights are chosen by: as for the ray.

PURE real light_power(VirtualBeamLight light, MediumRecord medium) { return ray_power(light.ray, medium); }
PURE real estimate_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualBeamLight light, MediumRecord medium, real density)
{
    return estimate_ray_to_segment(eye, eye_medium, light.ray, medium, density);
}
PURE real estimate_to_point(EyePointLanes eye, VirtualBeamLight light, MediumRecord medium, real density) { return estimate_ray_to_point(eye, light.ray, medium, density); }

#endif
