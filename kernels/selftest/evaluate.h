/// Every sampler behind one call, so that the same tables of cases run on the host and on a device. Written in the kernels' dialect.
#ifndef EVALUATE_H
#define EVALUATE_H

#include "kernels/math/maths.h"

#define SAMPLER_ROD 0u        // q a b length xi                    -> potential v floor_ratio invert(v)
#define SAMPLER_ANGLE 1u      // p a length xi                      -> u angle angle_over_distance invert(u)
#define SAMPLER_PAIR 2u       // q a b light-length eye-length xi xi -> weight v u floor_ratio
#define SAMPLER_PHASE 3u      // in out g                           -> phase_henyey_greenstein
#define SAMPLER_SCATTER 4u    // g xi                               -> cosine 1-cosine 1+cosine invert
#define SAMPLER_DISTANCE 5u   // sigma_t length xi                  -> t pdf(t) invert(t) transmittance(sigma_t length)
#define SAMPLER_SURFACE 6u    // p b length n xi                    -> v weight pdf(v) invert(v)
#define SAMPLER_LINEAR 7u     // f0 f1 xi                           -> r pdf(r) invert(r)
#define SAMPLER_BALANCE 8u    // p1 p2                              -> share of 1, share of 2
#define SAMPLER_RATIO 9u      // optical depth, reference           -> transmittance_ratio
#define SAMPLER_ROD_PDF 10u   // q a b length v                     -> pdf
#define SAMPLER_COUNT 11u

typedef struct {
    real in[14];
} Inputs;
typedef struct {
    real out[4];
} Outputs;

PURE real3 input3(Inputs i, uint first) { return make_real3(i.in[first], i.in[first + 1u], i.in[first + 2u]); }

PURE Outputs outputs(real first, real second, real third, real fourth)
{
    Outputs o;
    o.out[0] = first;
    o.out[1] = second;
    o.out[2] = third;
    o.out[3] = fourth;
    return o;
}

PURE Outputs evaluate_rod(Inputs i)
{
    RodSample s = sample_rod(input3(i, 0u), input3(i, 3u), input3(i, 6u), i.in[9], i.in[10]);
    return outputs(s.potential, s.v, s.floor_ratio, invert_rod(input3(i, 0u), input3(i, 3u), input3(i, 6u), i.in[9], s.v));
}

PURE Outputs evaluate_angle(Inputs i)
{
    AngleSample s = sample_equiangular(input3(i, 0u), input3(i, 3u), i.in[6], i.in[7]);
    return outputs(s.u, s.angle, s.angle_over_distance, invert_equiangular(input3(i, 0u), input3(i, 3u), i.in[6], s.u));
}

PURE Outputs evaluate_pair(Inputs i)
{
    RodSample rod = sample_rod(input3(i, 0u), input3(i, 3u), input3(i, 6u), i.in[9], i.in[11]);
    AngleSample angle = sample_equiangular(along3(input3(i, 0u), rod.v, input3(i, 6u)), input3(i, 3u), i.in[10], i.in[12]);
    return outputs(pair_weight(rod, angle), rod.v, angle.u, rod.floor_ratio);
}

PURE Outputs evaluate_scatter(Inputs i)
{
    ScatterCosine c = sample_henyey_greenstein_cosine(i.in[0], i.in[1]);
    return outputs(sample_henyey_greenstein(i.in[0], i.in[1]), c.one_minus, c.one_plus, invert_henyey_greenstein(i.in[0], c));
}

PURE Outputs evaluate_distance(Inputs i)
{
    real t = sample_distance(i.in[0], i.in[1], i.in[2]);
    return outputs(t, pdf_distance(i.in[0], i.in[1], t), invert_distance(i.in[0], i.in[1], t), transmittance(i.in[0] * i.in[1]));
}

PURE Outputs evaluate_surface(Inputs i)
{
    real3 p = input3(i, 0u), b = input3(i, 3u), n = input3(i, 7u);
    SurfaceRodSample s = sample_surface_rod(p, b, i.in[6], n, i.in[10]);
    return outputs(s.v, s.weight, pdf_surface_rod(p, b, i.in[6], n, s.v), invert_surface_rod(p, b, i.in[6], n, s.v));
}

PURE Outputs evaluate_linear(Inputs i)
{
    real r = sample_linear(i.in[0], i.in[1], i.in[2]);
    return outputs(r, pdf_linear(i.in[0], i.in[1], r), invert_linear(i.in[0], i.in[1], r), R(0.0));
}

PURE Outputs evaluate(uint sampler, Inputs i)
{
    if (sampler == SAMPLER_ROD) return evaluate_rod(i);
    if (sampler == SAMPLER_ANGLE) return evaluate_angle(i);
    if (sampler == SAMPLER_PAIR) return evaluate_pair(i);
    if (sampler == SAMPLER_PHASE) return outputs(phase_henyey_greenstein(input3(i, 0u), input3(i, 3u), i.in[6]), R(0.0), R(0.0), R(0.0));
    if (sampler == SAMPLER_SCATTER) return evaluate_scatter(i);
    if (sampler == SAMPLER_DISTANCE) return evaluate_distance(i);
    if (sampler == SAMPLER_SURFACE) return evaluate_surface(i);
    if (sampler == SAMPLER_LINEAR) return evaluate_linear(i);
    if (sampler == SAMPLER_BALANCE) return outputs(balance_weight(i.in[0], i.in[1]), balance_weight(i.in[1], i.in[0]), R(0.0), R(0.0));
    if (sampler == SAMPLER_RATIO) return outputs(transmittance_ratio(i.in[0], i.in[1]), R(0.0), R(0.0), R(0.0));
    return outputs(pdf_rod(input3(i, 0u), input3(i, 3u), input3(i, 6u), i.in[9], i.in[10]), R(0.0), R(0.0), R(0.0));
}

#endif
