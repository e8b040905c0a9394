// What the stages call an eye, when eyes are points on surfaces: virtual light to surface.
#ifndef EYE_KIND_H
#define EYE_KIND_H

#include "kernels/stages/load_points.h"

typedef PlaceFromPoint OnLight;
typedef PlaceFromPoint OnBoth;
PURE OnLight place_light(Eye eye, Light light, MediumRecord medium, real xi) { return place_on_light_from_point(eye.geometry, light, xi); }
PURE OnBoth place_eye(Eye eye, Light light, MediumRecord medium, PhaseTables tables, OnLight on_light, real xi) { return on_light; }
PURE Connection connect_eye(Eye eye, Light light, MediumRecord medium, PhaseTables tables, OnBoth at, Matter on_eye, Matter on_light)
{
    return connect_point_at(eye.geometry, light, medium, tables, at, on_light);
}

static inline real estimate_light(Eye eye, Light light, MediumRecord medium, real density) { return estimate_to_point(eye.geometry, light, medium, density); }

/// Nothing lies along a point.
PURE Matter matter_to_eye(OnBoth at) { return even_matter(R(0.0)); }

// Density grids: the same functions as for segments, with nothing along the eye.

PURE OnLight find_light(Eye eye, Light light, MediumRecord medium, real v) { return find_on_light_from_point(eye.geometry, light, v); }
PURE OnBoth find_eye(Eye eye, const OpticalTable* table, Light light, MediumRecord medium, PhaseTables tables, OnLight on_light, real xi) { return on_light; }
PURE Passed passed_to_eye(Eye eye, const OpticalTable* table, OnBoth at)
{
    Passed none = {make_real3(R(0.0), R(0.0), R(0.0)), make_real3(R(0.0), R(0.0), R(0.0))};
    return none;
}
PURE OnBoth share_pair(Eye eye, real over_mass, Light light, OnBoth at, Passed to_eye, MatterDensity on_light, real share)
{
    return share_place(eye.geometry, light, at, on_light.factor * transmittance(on_light.depth), share);
}
PURE Matter matter_at_eye(Surroundings s, const MediaOfGroup* media, Eye eye, OnBoth at, real3 path) { return even_matter(R(0.0)); }
PURE Matter exact_matter_at_eye(Surroundings s, const MediaOfGroup* media, Eye eye, const OpticalTable* table, OnBoth at) { return even_matter(R(0.0)); }

/// Where its connections start.
PURE real3 eye_position(Eye eye) { return eye.geometry.position; }

#endif
