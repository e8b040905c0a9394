// What the stages call an eye, when eyes are segments: virtual light to medium.
#ifndef EYE_KIND_H
#define EYE_KIND_H

#include "kernels/stages/load_segments.h"

typedef PlaceOnLight OnLight;
typedef Places OnBoth;
PURE OnLight place_light(Eye eye, Light light, MediumRecord medium, real xi) { return place_on_light(eye.geometry, eye.medium, light, medium, xi); }
PURE OnBoth place_eye(Eye eye, Light light, MediumRecord medium, PhaseTables tables, OnLight on_light, real xi)
{
    return place_on_segment(eye.geometry, eye.medium, light, medium, on_light, tables, xi);
}
PURE Connection connect_eye(Eye eye, Light light, MediumRecord medium, PhaseTables tables, OnBoth at, Matter on_eye, Matter on_light)
{
    return connect_segment_at(eye.geometry, eye.medium, light, medium, tables, at, on_eye, on_light);
}

static inline real estimate_light(Eye eye, Light light, MediumRecord medium, real density)
{
    return estimate_to_segment(eye.geometry, eye.medium, light, medium, density);
}

/// What lies along an eye in homogeneous media.
PURE Matter matter_to_eye(OnBoth at) { return even_matter(at.u); }

// Density grids.

/// A place on the light that its table drew, and one on the eye that its own draws, weighed as if the light had placed them.
PURE OnLight find_light(Eye eye, Light light, MediumRecord medium, real v) { return find_on_light(eye.geometry, eye.medium, light, medium, v); }
PURE OnBoth find_eye(Eye eye, const OpticalTable* table, Light light, MediumRecord medium, PhaseTables tables, OnLight on_light, real xi)
{
    real u = sample_matter(*table, eye.medium.sigma_t, eye.geometry.length, 0u, xi);
    return find_on_segment(eye.geometry, eye.medium, light, medium, on_light, tables, u);
}

PURE Passed passed_to_eye(Eye eye, const OpticalTable* table, OnBoth at) { return passed(*table, at.u); }

/// The places with their weight under both ways of drawing; `on_light`: density of the table on the light, over_mass of the eye's.
PURE OnBoth share_pair(Eye eye, real over_mass, Light light, OnBoth at, Passed to_eye, MatterDensity on_light, real share)
{
    MatterDensity on_eye = matter_density(to_eye, eye.medium.sigma_t, over_mass, 0u);
    return share_places(eye.geometry, light, at, on_eye.factor * on_light.factor * transmittance(on_eye.depth + on_light.depth), share);
}

/// What scatters at the eye's end of the connection.
PURE Matter matter_at_eye(Surroundings s, const MediaOfGroup* media, Eye eye, OnBoth at, real3 path)
{
    Matter m = {path, scattering_of_group(s, media, along3(eye.geometry.origin, at.u, eye.geometry.direction))};
    return m;
}

/// The same exactly.
PURE Matter exact_matter_at_eye(Surroundings s, const MediaOfGroup* media, Eye eye, const OpticalTable* table, OnBoth at) { return exact_matter_along_eye(s, media, eye, table, at.u); }

/// Where its connections start: all of a segment is inside the container whose medium it is in.
PURE real3 eye_position(Eye eye) { return along3(eye.geometry.origin, R(0.5) * eye.geometry.length, eye.geometry.direction); }

#endif
