/// Geometry that lights without extent share, in media and on surfaces: where an eye segment is joined to a point, and what a surface point sees of it (kernels/README.md, section 17).
#ifndef POINT_LIGHT_H
#define POINT_LIGHT_H

#include "kernels/math/eye_and_light.h"

/// The place on the light: there is one.
typedef struct { real v; } PointPlace;
PURE PointPlace point_place(void)
{
    PointPlace place = {R(0.0)};
    return place;
}

/// u with the weight 1 / (w^2 pdf(u)) = R / q (eq. 58): finite at contact, where R is as large as its guard lets it be.
PURE Places place_beside_point(AngleSample angle, real warp_density)
{
    Places places;
    places.v = R(0.0), places.u = angle.u;
    places.weight = angle.angle_over_distance / warp_density;
    places.floored = angle.u < R(0.0);                              // never: the angle has no floor
    return places;
}

/// The place with the weight that it has when with the chance `share` it is drawn with density `other`, per length of u, instead. light: where it is.
PURE Places share_beside_point(EyeSegmentLanes eye, real3 light, Places at, real other, real share)
{
    real3 d = along3(sub3(light, eye.origin), -at.u, eye.direction);
    at.weight = shared_weight(at.weight, other * dot3(d, d), share);
    return at;
}

/// A surface point's place on it: nothing is drawn.
typedef struct {
    real v;
    real weight;   ///< max(n . omega, 0) / w^2
    mask floored;  ///< nearer than positions can tell: the floor of eq. 59 was active
} PointFromPoint;

/// w^2 is formed in units of a power of two of its size, which is at least epsilon^2 of the larger position: nearer is nothing that rounding left (eq. 59).
PURE PointFromPoint place_from_point(EyePointLanes eye, real3 light)
{
    real3 d = sub3(light, eye.position);
    real nearest = fmax(REAL_EPSILON * REAL_EPSILON * fmax(largest3(light), largest3(eye.position)), R(0x1p-62));  // so that 1 / w^2 is a float
    real size = largest3(d), inverse = reciprocal_power_of_two(fmax(size, nearest));
    real3 q = scale3(d, inverse);
    real w2 = fmax(dot3(q, q), R(1.0));                             // at least 1 but under the floor
    PointFromPoint place;
    place.v = R(0.0);
    place.weight = fmax(dot3(eye.normal, q), R(0.0)) / (w2 * sqrt(w2)) * inverse * inverse;
    place.floored = size < nearest;
    return place;
}

#endif
