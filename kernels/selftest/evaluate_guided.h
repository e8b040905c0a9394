/// Cases of densities that follow the light: the product conditionals, the tabulated marginals, phase functions with lobes (kernels/README.md, sections 6, 9 and 14).
/// Written in the kernels' dialect; EVALUATE_H comes first.
#ifndef EVALUATE_GUIDED_H
#define EVALUATE_GUIDED_H

#include "kernels/math/maths.h"

/// One of the phase functions of kernels/selftest/case_tables.hpp.
PURE PhaseRange case_phase(uint number)
{
    PhaseRange rayleigh = {0u, 1u, 0.0f}, table = {1u, 1u, 0.5f}, both_ways = {2u, 2u, 0.0f}, blend = {4u, 3u, 0.5f}, spike = {7u, 1u, 0.05f};
    if (number == 0u) return rayleigh;
    if (number == 1u) return table;
    if (number == 2u) return both_ways;
    if (number == 3u) return blend;
    return spike;
}

PURE PhaseLanes lanes_of_one(PhaseRange range)
{
    PhaseLanes lanes;
    lanes.count = 1u, lanes.has_lobes = 1u, lanes.which = to_bits(R(0.0));
    lanes.ranges[0] = range, lanes.medium[0] = 0u;
    return lanes;
}

/// The connection that a fraction x of the angle stands for.
typedef struct {
    real3 direction;  ///< from the point to the eye segment
    real way;         ///< along the eye segment and along the connection together
} CaseConnection;

PURE CaseConnection case_connection(real3 p, real3 a, real length, real x)
{
    real u = sample_equiangular(p, a, length, x).u;
    real3 d = make_real3(fma(u, a.x, -p.x), fma(u, a.y, -p.y), fma(u, a.z, -p.z));
    real w = length3(d), inverse = R(1.0) / fmax(w, REAL_SMALLEST);
    CaseConnection c;
    c.direction = make_real3(d.x * inverse, d.y * inverse, d.z * inverse);
    c.way = u + w;
    return c;
}

PURE real3 backwards(real3 a) { return make_real3(-a.x, -a.y, -a.z); }

/// Product of the phase functions and the transmittance over the density that drew them; x; that density.
PURE Outputs evaluate_warp(Inputs i, WarpShape shape)
{
    real3 p = input3(i, 0u), a = input3(i, 3u), b = input3(i, 6u);
    real g = i.in[10], sigma = i.in[12];
    GuideMedia media = {g, g, sigma, sigma, sigma};
    PhaseWarp warp = sample_phase_product(p, a, i.in[9], b, media, shape, i.in[11]);
    CaseConnection c = case_connection(p, a, i.in[9], warp.x);
    real both = phase_henyey_greenstein(b, c.direction, g) * phase_henyey_greenstein(c.direction, backwards(a), g);
    return outputs(both * transmittance(sigma * c.way) / warp.density, warp.x, warp.density, R(0.0));
}

/// Potential times the distance to the eye line at v, whose mean is the light's length; v; floor ratio; the xi of v.
PURE Outputs evaluate_marginal(Inputs i, TableShape shape)
{
    real3 q = input3(i, 0u), a = input3(i, 3u), b = input3(i, 6u);
    GuideMedia media = {i.in[12], i.in[12], i.in[13], i.in[13], i.in[13]};
    RodSample rod = sample_rod_table(q, a, b, i.in[9], i.in[10], media, shape, i.in[11]);
    real distance = length3(cross3(along3(q, rod.v, b), a));
    return outputs(rod.potential * distance, rod.v, rod.floor_ratio, invert_rod_table(q, a, b, i.in[9], i.in[10], media, shape, rod.v));
}

/// As evaluate_warp, for one of the phase functions with lobes.
PURE Outputs evaluate_lobe_warp(Inputs i, PhaseRange range, PhaseTables tables)
{
    real3 p = input3(i, 0u), a = input3(i, 3u), b = input3(i, 6u);
    GuideMedia media = {(real)range.g, (real)range.g, R(0.0), R(0.0), R(0.0)};
    WarpShape shape = {PHASE_VERTICES, 1, 0};
    PhaseWarp warp = sample_lobe_product(p, a, i.in[9], b, media, lanes_of_one(range), range, tables, shape, i.in[11]);
    CaseConnection c = case_connection(p, a, i.in[9], warp.x);
    real both = phase_of(range, tables, b, c.direction) * phase_of(range, tables, c.direction, backwards(a));
    return outputs(both / warp.density, warp.x, warp.density, R(0.0));
}

#endif
