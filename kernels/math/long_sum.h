/// A sum of many terms in two floats: `high + low` is exact to twice the precision of `real`, so that adding blocks in a fixed order does not depend on
/// how the blocks were cut into launches, and 1e6 lights do not stagnate (hard_cases row 26).
#ifndef LONG_SUM_H
#define LONG_SUM_H

typedef struct { real high, low; } LongSum;

/// s + x: the rounding error of the float sum is found exactly (two-sum [Knuth 1997, 4.2.2]) and kept. Any finite inputs.
PURE LongSum add_to(LongSum s, real x)
{
    LongSum r;
    r.high = s.high + x;
    real back = r.high - s.high;
    r.low = s.low + ((s.high - (r.high - back)) + (x - back));
    return r;
}

#endif
