/// A virtual ray light [Novak et al. 2012]: a piece of a light path inside one medium, shining from everywhere along it. This file is what every stage
/// needs to know of it; the mathematics is kernels/math/ray_light.h.
#ifndef VIRTUAL_RAY_LIGHT_H
#define VIRTUAL_RAY_LIGHT_H

#include "kernels/math/ray_light.h"

typedef RayLight VirtualRayLight;
typedef VirtualRayLight Light;

enum { LIGHT_IS_LINE = 1, LIGHT_ON_SURFACE = 0 };  ///< shines from everywhere between its origin and light_length along its direction
PURE uint light_medium(VirtualRayLight light) { return light.medium; }
PURE uint light_depth(VirtualRayLight light) { return light.depth; }
PURE real3 light_origin(VirtualRayLight light) { return ray_origin(light); }
PURE real3 light_direction(VirtualRayLight light) { return ray_direction(light); }
PURE float light_length(VirtualRayLight light) { return light.length; }
/// 1: what it sends is divided by the chance of getting that far along it, so that it shines evenly.
PURE uint light_is_even(VirtualRayLight light) { return SHORT_LIGHTS && light.is_short != 0u ? 1u : 0u; }

// An eye segment's connection in three steps. Each is short enough for a processor to overlap it with the same step of the next pair, which all three
// together are not; so the stages take a batch of pairs through one step before the next (kernels/stages/connection.h).

typedef RodSample PlaceOnLight;
PURE PlaceOnLight place_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, real xi)
{
    return place_on_ray(eye, eye_medium, light, medium, xi);
}
PURE Places place_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real xi)
{
    return place_beside_ray(eye, eye_medium, light, medium, on_light, tables, xi);
}

/// Steps 1 and 2 for places that another density has drawn: the weight that the two would have given them.
PURE PlaceOnLight find_on_light(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, real v)
{
    return find_on_ray(eye, eye_medium, light, medium, v);
}
PURE Places find_on_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, PlaceOnLight on_light, PhaseTables tables, real u)
{
    return find_beside_ray(eye, eye_medium, light, medium, on_light, tables, u);
}
PURE Places share_places(EyeSegmentLanes eye, VirtualRayLight light, Places at, real other, real share) { return share_ray_places(eye, light, at, other, share); }

PURE Connection connect_segment_at(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, PhaseTables tables, Places at,
                                    Matter on_eye, Matter on_light)
{
    return connect_ray_to_segment(eye, eye_medium, light, medium, tables, at, on_eye, on_light);
}

/// The three steps for one pair in homogeneous media.
PURE Connection connect_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceOnLight on_light = place_on_light(eye, eye_medium, light, medium, xi.first);
    Places at = place_on_segment(eye, eye_medium, light, medium, on_light, tables, xi.second);
    return connect_segment_at(eye, eye_medium, light, medium, tables, at, even_matter(at.u), even_matter(at.v));
}

// A surface point's in two.

typedef SurfaceRodSample PlaceFromPoint;
PURE PlaceFromPoint place_on_light_from_point(EyePointLanes eye, VirtualRayLight light, real xi) { return place_on_ray_from_point(eye, light, xi); }
PURE PlaceFromPoint find_on_light_from_point(EyePointLanes eye, VirtualRayLight light, real v) { return find_on_ray_from_point(eye, light, v); }
PURE PlaceFromPoint share_place(EyePointLanes eye, VirtualRayLight light, PlaceFromPoint at, real other, real share) { return share_ray_place(eye, light, at, other, share); }
PURE Connection connect_point_at(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, PhaseTables tables, PlaceFromPoint at, Matter on_light)
{
    return connect_ray_to_point(eye, light, medium, tables, at, on_light);
}

/// The two steps for one pair in homogeneous media.
PURE Connection connect_point(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, PhaseTables tables, Random2 xi)
{
    PlaceFromPoint at = place_on_light_from_point(eye, light, xi.first);
    return connect_point_at(eye, light, medium, tables, at, even_matter(at.v));
}

// What lights are chosen by (kernels/README.md, section 16).

PURE real light_power(VirtualRayLight light, MediumRecord medium) { return ray_power(light, medium); }
PURE real estimate_to_segment(EyeSegmentLanes eye, MediumLanes eye_medium, VirtualRayLight light, MediumRecord medium, real density)
{
    return estimate_ray_to_segment(eye, eye_medium, light, medium, density);
}
PURE real estimate_to_point(EyePointLanes eye, VirtualRayLight light, MediumRecord medium, real density) { return estimate_ray_to_point(eye, light, medium, density); }

#endif
