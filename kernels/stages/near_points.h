// What gather_near calls an eye, when eyes are points on surfaces: they take from light paths that arrive near.
#ifndef NEAR_EYE_H
#define NEAR_EYE_H

#include "kernels/stages/load_points.h"

PURE Meeting meet_eye(Eye eye, Surroundings s, Light light, real xi) { return meet_point(eye.geometry, light); }
PURE real3 gather_eye(Eye eye, const NearGroup* around, Surroundings s, Light light, uint number, Meeting at) { return gather_at_point(eye.geometry, light, at); }

#endif
