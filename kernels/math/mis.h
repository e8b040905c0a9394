/// Multiple importance sampling [Veach and Guibas 1995].
#ifndef MIS_H
#define MIS_H

#include "kernels/dialect.h"

/// Balance heuristic: share of the technique with density p1 against one with density p2, 0 <= p <= infinity. The larger is the denominator, so nothing
/// overflows; p2 = 0 gives 1, p1 = 0 gives 0, both infinite or both 0 give 1/2: the two shares always add up to 1 (eq. 27).
PURE real balance_weight(real p1, real p2)
{
    mask larger = p1 >= p2;
    real ratio = select(p1, p2, larger) / select(p2, p1, larger);  // smaller / larger
    ratio = select(ratio, R(1.0), p1 == p2);
    return select(ratio, R(1.0), larger) / (R(1.0) + ratio);
}

/// The weight 1 / p of a sample that one technique would have drawn with density p, when with the chance `share` another one draws instead, with density
/// `other`: 1 / ((1 - share) p + share other), without 1 / weight. The result does not depend on which of the two drew. share = 0 gives `weight` itself (eq. 48).
PURE real shared_weight(real weight, real other, real share) { return weight / fma(share, other * weight, R(1.0) - share); }

#endif
