// What one core can do at most, each measured by a loop of nothing else. One work-item; `rounds` times 12 independent operations on 16 lanes, or a walk over an array.
#define TWELVE(step) step(a0) step(a1) step(a2) step(a3) step(a4) step(a5) step(a6) step(a7) step(a8) step(a9) step(a10) step(a11)
#define DECLARE(x) float16 x = (float16)(start + 1.0f);
#define FMA(x) x = fma(x, factor, start);
#define DIVIDE(x) x = factor / x;
#define ROOT(x) x = sqrt(x);
#define ADD_UP (a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7 + a8 + a9 + a10 + a11)

__kernel void fused(uint rounds, float start, __global float16* out)
{
    float16 factor = (float16)(1.0f - start);
    TWELVE(DECLARE)
    for (uint i = 0; i < rounds; ++i) { TWELVE(FMA) }
    *out = ADD_UP;
}

__kernel void divided(uint rounds, float start, __global float16* out)
{
    float16 factor = (float16)(1.0f - start);
    TWELVE(DECLARE)
    for (uint i = 0; i < rounds; ++i) { TWELVE(DIVIDE) }
    *out = ADD_UP;
}

__kernel void rooted(uint rounds, float start, __global float16* out)
{
    TWELVE(DECLARE)
    for (uint i = 0; i < rounds; ++i) { TWELVE(ROOT) }
    *out = ADD_UP;
}

/// vectors: a multiple of 8.
__kernel void loaded(uint rounds, uint vectors, __global const float16* in, __global float16* out)
{
    float16 a0 = 0, a1 = 0, a2 = 0, a3 = 0, a4 = 0, a5 = 0, a6 = 0, a7 = 0;
    for (uint i = 0; i < rounds; ++i)
        for (uint k = 0; k < vectors; k += 8) {
            a0 += in[k], a1 += in[k + 1], a2 += in[k + 2], a3 += in[k + 3];
            a4 += in[k + 4], a5 += in[k + 5], a6 += in[k + 6], a7 += in[k + 7];
        }
    *out = a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7;
}
