/// 1 / (w^2 pdf(v) pdf(u|v)) with everything cancelled that can be: no 1 / w^2, no density, no 0 / 0 (kernels/README.md, eqs. 14-15).
#ifndef PAIR_WEIGHT_H
#define PAIR_WEIGHT_H

#include "kernels/math/equiangular.h"
#include "kernels/math/rod.h"

/// Weight of the connection that the two samples make: E Theta, at most pi E; E D_floor R where the floor on D is active. No unit. Always finite.
PURE real pair_weight(RodSample rod, AngleSample angle)
{
    mask floored = rod.floor_ratio > R(1.0);
    real weight = rod.potential * angle.angle;
    if (any_lane(floored)) weight = select(weight, rod.potential * (rod.distance * angle.angle_over_distance), floored);
    return weight;
}

#endif
