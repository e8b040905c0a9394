/// Every sampler behind one call, so that the same tables of cases run on the host and on a device. Written in the kernels' dialect.
#ifndef EVALUATE_H
#define EVALUATE_H

#include "kernels/math/maths.h"
#include "kernels/volumes/grid_walk.h"

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
#define SAMPLER_WARP_10 11u   // p a b length g xi sigma            -> product / density, x, density: conditional of sampler paper
#define SAMPLER_WARP_10T 12u  // the same with transmittance: of table
#define SAMPLER_WARP_6T 13u   // six vertices: of paper-6 and table-4x4
#define SAMPLER_WARP_4T 14u   // four: of table-3x2
#define SAMPLER_MARGINAL_8X6 15u  // q a b light-length eye-length xi g sigma -> potential times distance, v, floor_ratio, invert(v): of table
#define SAMPLER_MARGINAL_4X4 16u
#define SAMPLER_MARGINAL_3X2 17u
#define SAMPLER_PHASE_OF 18u  // in out                             -> phase_of the first of five phase functions with lobes; then the others
#define SAMPLER_LOBE_WARP 23u // p a b length - xi                  -> product / density, x, density: for the first of them; then the others
#define SAMPLER_GRID 28u      // from to                            -> depth, value, clamped value, depth of the last channel: of the first of four grids; then the others
#define SAMPLER_COUNT 32u
/// Which of them a build holds, as bits: what a render does not use need not be compiled before it.
#define CASES_PLAIN 1u   // the first eleven
#define CASES_PRODUCTS 2u
#define CASES_MARGINALS 4u
#define CASES_LOBES 8u
#define CASES_GRIDS 16u
#ifndef CASE_FAMILIES
#define CASE_FAMILIES 31u
#endif
#define CASE_PHASES 5u
#define CASE_COLOURED_GRID 3u  // the one with three channels

typedef struct {
    real in[14];
} Inputs;
typedef struct {
    real out[4];
} Outputs;

/// Records of kernels/selftest/case_tables.hpp.
typedef struct {
    PhaseTables phases;              ///< its values hold the voxels too
    __global const GridRecord* grids;
} CaseTables;

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

PURE Outputs evaluate_grid_case(Inputs i, uint number, CaseTables t)
{
    real3 from = input3(i, 0u), to = input3(i, 3u);
    GridRecord grid = t.grids[number];
    real length = length3(sub3(to, from)), depth = grid_optical_depth(grid, t.phases.values, from, to, length), last = depth;
    if (number == CASE_COLOURED_GRID) last = grid_optical_depth3(grid, t.phases.values, from, to, length).z;
    return outputs(depth, grid_value(grid, t.phases.values, from), grid_value_clamped(grid, t.phases.values, from), last);
}

#include "kernels/selftest/evaluate_guided.h"

PURE Outputs evaluate_product(uint sampler, Inputs i)
{
    WarpShape shape = {sampler == SAMPLER_WARP_6T ? 6 : sampler == SAMPLER_WARP_4T ? 4 : PHASE_VERTICES, 1, sampler != SAMPLER_WARP_10};
    return evaluate_warp(i, shape);
}

PURE Outputs evaluate_tabulated(uint sampler, Inputs i)
{
    TableShape large = {8, 6, 1}, middle = {4, 4, 1}, small = {3, 2, 1};
    return evaluate_marginal(i, sampler == SAMPLER_MARGINAL_8X6 ? large : sampler == SAMPLER_MARGINAL_4X4 ? middle : small);
}

PURE Outputs evaluate_lobes(uint sampler, Inputs i, PhaseTables tables)
{
    if (sampler >= SAMPLER_LOBE_WARP) return evaluate_lobe_warp(i, case_phase(sampler - SAMPLER_LOBE_WARP), tables);
    return outputs(phase_of(case_phase(sampler - SAMPLER_PHASE_OF), tables, input3(i, 0u), input3(i, 3u)), R(0.0), R(0.0), R(0.0));
}

/// The samplers that need nothing but inputs.
PURE Outputs evaluate_plain(uint sampler, Inputs i)
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

PURE Outputs evaluate(uint sampler, Inputs i, CaseTables t)
{
    if (sampler < SAMPLER_WARP_10) return evaluate_plain(sampler, i);
    if ((CASE_FAMILIES & CASES_PRODUCTS) && sampler < SAMPLER_MARGINAL_8X6) return evaluate_product(sampler, i);
    if ((CASE_FAMILIES & CASES_MARGINALS) && sampler >= SAMPLER_MARGINAL_8X6 && sampler < SAMPLER_PHASE_OF) return evaluate_tabulated(sampler, i);
    if ((CASE_FAMILIES & CASES_LOBES) && sampler >= SAMPLER_PHASE_OF && sampler < SAMPLER_GRID) return evaluate_lobes(sampler, i, t.phases);
    if ((CASE_FAMILIES & CASES_GRIDS) && sampler >= SAMPLER_GRID) return evaluate_grid_case(i, sampler - SAMPLER_GRID, t);
    return outputs(R(0.0), R(0.0), R(0.0), R(0.0));
}

#endif
