/// Random numbers as a pure function of what they are for.
#ifndef RANDOM_H
#define RANDOM_H

#include "kernels/dialect.h"

typedef struct { real first, second; } Random2;

/// A bijection of 32 bits in which every bit of the argument changes every bit of the result with probability 1/2 +- .001: shifts and multipliers
/// found by search [Wellons 2018, lowbias32]. Once for lanes, once for the scalars that all lanes share.
PURE bits mix_lanes(bits x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
PURE uint mix_scalar(uint x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Two numbers in [0, 1), multiples of 2^-24 (so never 1, in float either), from (key, counter). For a fixed counter the first is a bijection of the
/// key; keys and counters may be consecutive. Statistics: tests/math/random_test.cpp.
PURE Random2 random2(bits key, uint counter)
{
    uint first_shift = mix_scalar(counter + 0x9e3779b9u), second_shift = mix_scalar(first_shift + 0x9e3779b9u);
    bits x = mix_lanes(key + first_shift), y = mix_lanes(x ^ second_shift);
    Random2 xi;
    xi.first = to_real(x >> 8) * R(0x1p-24);
    xi.second = to_real(y >> 8) * R(0x1p-24);
    return xi;
}

#endif
