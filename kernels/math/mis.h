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

#endif
