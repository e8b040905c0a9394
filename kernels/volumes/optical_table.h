/// Tables of the density met along a ray: its integral from the start to 65 equally spaced nodes, exact there, linear between. They give the transmittance up
/// to any point, and a place on the ray in proportion to sigma_t T (kernels/README.md, section 13).
#ifndef OPTICAL_TABLE_H
#define OPTICAL_TABLE_H

#include "kernels/math/maths.h"

#define TABLE_INTERVALS 64u
#define TABLE_NODES 65u
#define TABLE_CHANNELS (COLOURED_GRIDS ? 3u : 1u)
#define TABLE_FLOATS (TABLE_NODES * TABLE_CHANNELS + 1u)  // of one ray: the nodes of each channel, then over_mass

/// Beyond this optical depth nothing is left: e^-80 = 2e-35 (and expm1 in float ends at 87).
#define DEEPEST R(80.0)

/// One table for every lane: node i of channel c of a lane is first[(c TABLE_NODES + i) stride + lane].
typedef struct {
    __global const float* first;
    uint stride;
    bits lane;
    real per_length;  ///< intervals per unit of length
} OpticalTable;

PURE real intervals_per_length(real length) { return (real)(float)TABLE_INTERVALS / fmax(length, REAL_SMALLEST); }

/// What lies along the ray up to a point, per channel, in units of length: integral of the density, and its mean in the interval of the point.
typedef struct { real3 path, density; } Passed;

PURE real table_node(OpticalTable t, uint channel, real node) { return gather_lanes(t.first + channel * TABLE_NODES * t.stride, to_bits(node) * t.stride + t.lane); }

/// Number of the interval of the distance x along a ray, 0 ... 63, whatever x is; `share` becomes where in it, 0 ... 1.
typedef struct { real node, share; } TablePlace;
PURE TablePlace table_place(OpticalTable t, real x)
{
    real at = fmin(fmax(x * t.per_length, R(0.0)), (real)(float)TABLE_INTERVALS);
    TablePlace p;
    p.node = fmin(to_real(to_whole(at)), (real)(float)(TABLE_INTERVALS - 1u));
    p.share = at - p.node;
    return p;
}

PURE Passed passed(OpticalTable t, real x)
{
    TablePlace p = table_place(t, x);
    real before = table_node(t, 0u, p.node), rise = table_node(t, 0u, p.node + R(1.0)) - before;
    Passed m;
    m.path.x = fma(p.share, rise, before), m.density.x = rise * t.per_length;
    m.path.y = m.path.z = m.path.x, m.density.y = m.density.z = m.density.x;
    if (COLOURED_GRIDS) {
        before = table_node(t, 1u, p.node), rise = table_node(t, 1u, p.node + R(1.0)) - before;
        m.path.y = fma(p.share, rise, before), m.density.y = rise * t.per_length;
        before = table_node(t, 2u, p.node), rise = table_node(t, 2u, p.node + R(1.0)) - before;
        m.path.z = fma(p.share, rise, before), m.density.z = rise * t.per_length;
    }
    return m;
}

/// The node at or before x, and the path up to it.
typedef struct {
    real x;
    real3 path;
} TableNode;
PURE TableNode node_below(OpticalTable t, real x, real length)
{
    TablePlace p = table_place(t, x);
    TableNode n;
    n.x = fmin(p.node * (length / (real)(float)TABLE_INTERVALS), x);
    real path = table_node(t, 0u, p.node);
    n.path = make_real3(path, path, path);
    if (COLOURED_GRIDS) n.path.y = table_node(t, 1u, p.node), n.path.z = table_node(t, 2u, p.node);
    return n;
}

/// Mean over the channels of the optical depth, or of the extinction, that belongs to an integral of the density, or to a density.
PURE real grey(real3 sigma_t, real3 path) { return (sigma_t.x * path.x + sigma_t.y * path.y + sigma_t.z * path.z) * R(0.33333333333333333); }

PURE real table_depth(OpticalTable t, real3 sigma_t, real node)
{
    real red = table_node(t, 0u, node);
    real3 path = make_real3(red, red, red);
    if (COLOURED_GRIDS) path.y = table_node(t, 1u, node), path.z = table_node(t, 2u, node);
    return fmin(grey(sigma_t, path), R(1e30));                    // infinite or not a number: finite, so that the search below ends in the table
}

/// Share of light that a grey optical depth takes away.
PURE real absorbed(real depth) { return fmin(depth, DEEPEST) * expm1_over(-fmin(depth, DEEPEST)); }

/// Distance along the ray in proportion to the grey extinction times its transmittance from the start, or to the extinction alone if `even`; the table's
/// lines taken for the depth. A ray that meets nothing gives any place, with density 0. xi in [0, 1).
PURE real sample_matter(OpticalTable t, real3 sigma_t, real length, uint even, real xi)
{
    real total = table_depth(t, sigma_t, (real)(float)TABLE_INTERVALS), part = xi * absorbed(total);
    real target = even ? xi * total : part * log1p_over(-part), node = R(0.0);
    for (uint step = TABLE_INTERVALS / 2u; step > 0u; step /= 2u) {
        real ahead = node + (real)(float)step;
        node = select(node, ahead, table_depth(t, sigma_t, ahead) <= target);
    }
    node = fmin(node, (real)(float)(TABLE_INTERVALS - 1u));
    real before = table_depth(t, sigma_t, node), rise = table_depth(t, sigma_t, node + R(1.0)) - before;
    real share = fmin(fmax((target - before) / fmax(rise, REAL_SMALLEST), R(0.0)), R(1.0));
    return fmin((node + share) * (length / (real)(float)TABLE_INTERVALS), length);
}

/// 1 / the chance that light of the grey extinction is stopped on a ray of the grey depth `total`, or 1 / total if `even`: what densities are scaled by.
PURE real over_mass(real total, uint even) { return R(1.0) / fmax(even ? total : absorbed(total), REAL_SMALLEST); }

/// Density of sample_matter where `m` was passed, per unit of length: factor x exp(-depth). Apart, so that both places of a pair share one exponential. The
/// factor is 0 where nothing scatters.
typedef struct { real factor, depth; } MatterDensity;
PURE MatterDensity matter_density(Passed m, real3 sigma_t, real over_mass, uint even)
{
    real extinction = grey(sigma_t, m.density);
    MatterDensity d;
    d.factor = select(R(0.0), extinction * over_mass, extinction > R(0.0));
    d.depth = even ? R(0.0) : fmin(grey(sigma_t, m.path), DEEPEST);
    return d;
}

#endif
