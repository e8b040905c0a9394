/// Random numbers as a pure function of what they are for.
#ifndef RANDOM_H
#define RANDOM_H

#include "kernels/dialect.h"

typedef struct { real first, second; } Random2;

/// Two numbers in [0, 1), multiples of 2^-24 (so never 1 in float), from (key, counter): a bijection of the 64 bits, two rounds of linear congruential
/// steps that feed each other, with the high half folded in between [Jarzynski and Olano 2020, pcg2d]. Statistics: tests/math/random_test.cpp.
PURE Random2 random2(bits key, uint counter)
{
    bits x = key * 1664525u + 1013904223u, y = (bits)(counter * 1664525u + 1013904223u);
    x += y * 1664525u;
    y += x * 1664525u;
    x ^= x >> 16;
    y ^= y >> 16;
    x += y * 1664525u;
    y += x * 1664525u;
    x ^= x >> 16;
    y ^= y >> 16;
    Random2 xi;
    xi.first = to_real(x >> 8) * R(0x1p-24);
    xi.second = to_real(y >> 8) * R(0x1p-24);
    return xi;
}

#endif
