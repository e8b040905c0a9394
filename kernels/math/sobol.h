/// Points that fill the unit square more evenly than random ones and are, each by itself, as uniform: Sobol's first two dimensions under a nested scramble
/// [Owen 1995], a pure function of (key, index) (kernels/README.md, eqs. 52-53). The points are handled with their bits mirrored, first binary digit lowest:
/// so the first dimension is the index itself.
#ifndef SOBOL_H
#define SOBOL_H

#include "kernels/math/random.h"

/// Sobol's second dimension, mirrored: bit j is the exclusive or of all bits k of the index for which the binomial coefficient (k over j) is odd, that is,
/// for which k contains every bit of j [Lucas 1878]. Five halvings add up these supersets.
PURE uint sobol_second(uint index)
{
    index = index ^ ((index >> 1) & 0x55555555u);
    index = index ^ ((index >> 2) & 0x33333333u);
    index = index ^ ((index >> 4) & 0x0f0f0f0fu);
    index = index ^ ((index >> 8) & 0x00ff00ffu);
    return index ^ (index >> 16);
}

PURE bits mirrored_bits(bits x)
{
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// A nested scramble of mirrored digits [Laine and Karras 2011], with multipliers found by search [Vegdahl 2021]: products with even numbers and sums carry
/// towards high bits only, so that a digit is flipped or not by the digits before it and the seed. A bijection for every seed.
PURE bits nested_scramble(bits x, bits seed)
{
    x = x ^ (x * 0x3d20adeau);
    x = x + seed;
    x = x * ((seed >> 16) | 1u);
    x = x ^ (x * 0x05526c56u);
    return x ^ (x * 0x53a22864u);
}

/// Two numbers in [0, 1), multiples of 2^-24. For one key the indices 0 ... 2^m - 1, and every later run of 2^m that starts at a multiple of 2^m, have one point
/// in each of the 2^m boxes 2^-i x 2^(i-m). For one index both are uniform over the keys and independent.
PURE Random2 scrambled_sobol2(bits key, uint index)
{
    // Mixed twice and in a chain, because the first digits ask for the lowest bits alone: mixed once, or both from one number, they are not independent.
    bits first_seed = mix_lanes(mix_lanes(key + 0x9e3779b9u) ^ 0xc2b2ae35u), second_seed = mix_lanes(first_seed ^ 0x85ebca6bu);
    bits x = nested_scramble((bits)(index), first_seed), y = nested_scramble((bits)(sobol_second(index)), second_seed);
    Random2 xi;
    xi.first = to_real(mirrored_bits(x) >> 8) * R(0x1p-24);
    xi.second = to_real(mirrored_bits(y) >> 8) * R(0x1p-24);
    return xi;
}

#endif
