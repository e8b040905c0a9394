/// Where on a virtual ray light to connect, better than the talk's marginal: a table of what the eye segment, not an infinite line, receives from each place,
/// over the fraction x of the rod potential, in which that is bounded and smooth (kernels/README.md, eqs. 49-51).
#ifndef ROD_TABLE_H
#define ROD_TABLE_H

#include "kernels/math/linear_piece.h"
#include "kernels/math/phase_product.h"
#include "kernels/math/rod.h"

#define MOST_NODES 8
/// Lobes narrower than this are missed by a handful of angles anyway; it keeps the values normal numbers.
#define NARROWEST_GUIDE R(0x1p-10)

/// Numbers that are known when the kernel is built.
typedef struct {
    int nodes;   ///< 2 ... MOST_NODES
    int angles;  ///< of the mid-point rule at each node
    int lobes;   ///< follow the phase functions
} TableShape;

/// The pair, in units of the rod frame.
typedef struct {
    real at_origin, slope;    ///< (q + v b) . a = at_origin + v slope
    real side, side_slope;    ///< the light's direction times the vector from its point away from the eye line: side + v side_slope
    real eye_length;
    GuideMedia media;         ///< extinctions in these units
} RodView;

PURE RodView rod_view(RodFrame f, real3 q, real3 a, real3 b, real eye_length, GuideMedia media)
{
    RodView view;
    real inverse = R(1.0) / f.scale, q_b = dot3(q, b) * inverse;
    view.at_origin = dot3(q, a) * inverse, view.slope = dot3(a, b);
    view.side = fma(-view.at_origin, view.slope, q_b), view.side_slope = f.s * f.s;
    view.eye_length = fmin(eye_length * inverse, LONGEST_SEGMENT);
    view.media = media;
    view.media.sigma_eye = media.sigma_eye * f.scale;
    view.media.sigma_light = media.sigma_light * f.scale;
    view.media.sigma_leg = media.sigma_leg * f.scale;
    return view;
}

/// (1 - |g|)^2 + 2 |g| (1 -+ mu), without the digits that the phase function itself needs near its peak.
PURE real blunt_lobe(real g, real mu)
{
    real gap = fmax(R(1.0) - fabs(g), NARROWEST_GUIDE);
    return fma(R(2.0) * (R(1.0) - gap), fmax(R(1.0) - select(-mu, mu, g >= R(0.0)), R(0.0)), gap * gap);
}

/// What a point of the light sees of the eye segment: sine and cosine of the first of the angles of the mid-point rule, and of the step to the next.
typedef struct {
    real D, foot, depth;                       ///< distance to the eye line, position of the foot; optical depth along the light
    real angle, across;                        ///< Theta; the light's direction times the unit vector to the foot
    real sine, cosine, step_sine, step_cosine;
} RodNode;

/// v: in units of the frame.
PURE RodNode rod_node(RodFrame f, RodView view, TableShape shape, real v)
{
    RodNode n;
    n.D = rod_distance(f, v), n.foot = fma(v, view.slope, view.at_origin), n.depth = view.media.sigma_light * v;
    real past = view.eye_length - n.foot, start = sqrt(fma(n.D, n.D, n.foot * n.foot)), over_both = R(1.0) / (start * n.D);
    n.angle = upper_atan2(n.D * view.eye_length, fma(n.D, n.D, -n.foot * past));
    n.across = fmin(fmax(-fma(v, view.side_slope, view.side) * start * over_both, R(-1.0)), R(1.0));
    real half_step = n.angle * (real)(0.5f / (float)shape.angles);
    SineCosine turn = sine_cosine(half_step);
    real s = turn.sine_over * half_step, c = turn.cosine, sine0 = n.D * n.D * over_both, cosine0 = n.foot * n.D * over_both;
    n.sine = fma(sine0, c, cosine0 * s), n.cosine = fma(cosine0, c, -sine0 * s);
    n.step_sine = R(2.0) * s * c, n.step_cosine = fma(R(-2.0) * s, s, R(1.0));
    return n;
}

/// The node, turned to the next angle.
PURE RodNode turned_node(RodNode n)
{
    RodNode next = n;
    next.sine = fma(n.sine, n.step_cosine, n.cosine * n.step_sine);
    next.cosine = fma(n.cosine, n.step_cosine, -n.sine * n.step_sine);
    return next;
}

/// Product of phase functions and transmittance at the node's angle.
PURE real node_value(RodView view, TableShape shape, RodNode n)
{
    real floored = fmax(n.sine, REAL_EPSILON), both = R(1.0), once = R(1.0) / floored, power = R(1.0), over = once;
    if (shape.lobes) {
        both = blunt_lobe(view.media.g_eye, n.cosine) * blunt_lobe(view.media.g_light, fma(n.across, n.sine, -view.slope * n.cosine));
        once = R(1.0) / (both * floored), over = once * both, power = once * floored, power = power * sqrt(power);
    }
    real furthest = n.D + fmax(fabs(n.foot), fabs(view.eye_length - n.foot));
    real w = fmin(n.D * over, furthest), u = fmin(fmax(fma(-n.D * n.cosine, over, n.foot), R(0.0)), view.eye_length);
    return power * decay(fmin(fma(view.media.sigma_eye, u, fma(view.media.sigma_leg, w, n.depth)), DEEPEST_GUIDE));
}

/// Values at equally spaced x, the defensive share in them, and their integral over x. A table without any light is even.
typedef struct {
    real value[MOST_NODES];
    real total;
} RodTable;

/// At each node the integral over Theta by the mid-point rule (eq. 50). All nodes go through one step before the next, for the reason that pairs do
/// (host/docs/performance.md).
PURE RodTable rod_table(RodFrame f, RodPiece whole, RodView view, TableShape shape)
{
    real v[MOST_NODES], last = (real)(float)(shape.nodes - 1), sum = R(0.0);
    RodNode node[MOST_NODES];
    RodTable t;
    for (int k = 0; k < shape.nodes; ++k) v[k] = rod_place(f, whole, (real)((float)k / (float)(shape.nodes - 1)));
    for (int k = 0; k < shape.nodes; ++k) node[k] = rod_node(f, view, shape, v[k]), t.value[k] = R(0.0);
    for (int i = 0; i < shape.angles; ++i)
        for (int k = 0; k < shape.nodes; ++k) {
            t.value[k] = fma(node_value(view, shape, node[k]), node[k].angle, t.value[k]);
            node[k] = turned_node(node[k]);
        }
    for (int k = 0; k < shape.nodes; ++k) sum = sum + t.value[k] * (k == 0 || k == shape.nodes - 1 ? R(0.5) : R(1.0));
    mask lit = sum > REAL_SMALLEST;
    real mean = select(R(1.0), sum / last, lit), even = mean * (DEFENSIVE_SHARE / (R(1.0) - DEFENSIVE_SHARE));
    for (int k = 0; k < shape.nodes; ++k) t.value[k] = select(R(1.0), t.value[k], lit) + even;
    t.total = mean + even;
    return t;
}

/// x in [0, 1] with the table's density, and that density relative to uniform, at least DEFENSIVE_SHARE.
PURE PhaseWarp warp_rod_table(RodTable t, TableShape shape, real xi)
{
    real last = (real)(float)(shape.nodes - 1), target = xi * t.total * last, f0 = t.value[0], f1 = t.value[1], from = R(0.0), below = R(0.0), sum = R(0.0);
    for (int k = 0; k + 1 < shape.nodes; ++k) {
        mask beyond = target >= sum;
        f0 = select(f0, t.value[k], beyond), f1 = select(f1, t.value[k + 1], beyond);
        from = select(from, (real)(float)k, beyond), below = select(below, sum, beyond);
        sum = fma(R(0.5), t.value[k] + t.value[k + 1], sum);
    }
    real within = fmin(fmax((target - below) / (R(0.5) * (f0 + f1)), R(0.0)), R(1.0)), r = sample_linear(f0, f1, within);
    PhaseWarp w;
    w.x = fmin((from + r) / last, R(1.0));
    w.density = fma(r, f1 - f0, f0) / t.total;
    return w;
}

/// As sample_rod, its potential divided by the density of x: 1 / (potential D) stays the density at v, and pair_weight what it is.
/// eye_length may be infinite; xi in [0, 1).
PURE RodSample sample_rod_table(real3 q, real3 a, real3 b, real length, real eye_length, GuideMedia media, TableShape shape, real xi)
{
    RodFrame f = rod_frame(q, a, b, length);
    RodPiece whole = rod_whole(f);
    PhaseWarp w = warp_rod_table(rod_table(f, whole, rod_view(f, q, a, b, eye_length, media), shape), shape, xi);
    RodSample rod = rod_sample_at(f, whole, rod_place(f, whole, w.x), length);
    rod.potential = rod.potential / w.density;
    return rod;
}

/// Density of x, relative to uniform, and the share of the table below x.
typedef struct { real density, below; } RodTablePlace;
PURE RodTablePlace place_in_rod_table(RodTable t, TableShape shape, real x)
{
    real last = (real)(float)(shape.nodes - 1), at = x * last, f0 = t.value[0], f1 = t.value[1], from = R(0.0), below = R(0.0), sum = R(0.0);
    for (int k = 0; k + 1 < shape.nodes; ++k) {
        mask beyond = at >= (real)(float)k;
        f0 = select(f0, t.value[k], beyond), f1 = select(f1, t.value[k + 1], beyond);
        from = select(from, (real)(float)k, beyond), below = select(below, sum, beyond);
        sum = fma(R(0.5), t.value[k] + t.value[k + 1], sum);
    }
    real r = fmin(at - from, R(1.0));
    RodTablePlace place;
    place.density = fma(r, f1 - f0, f0) / t.total;
    place.below = fma(r, fma(R(0.5) * r, f1 - f0, f0), below) / (t.total * last);
    return place;
}

/// What sample_rod_table returns when it draws v in [0, length].
PURE RodSample rod_table_at(real3 q, real3 a, real3 b, real length, real eye_length, GuideMedia media, TableShape shape, real v)
{
    RodFrame f = rod_frame(q, a, b, length);
    RodTable t = rod_table(f, rod_whole(f), rod_view(f, q, a, b, eye_length, media), shape);
    RodSample rod = rod_at(q, a, b, length, v);
    rod.potential = rod.potential / place_in_rod_table(t, shape, invert_rod(q, a, b, length, v)).density;
    return rod;
}

/// Density of sample_rod_table at v in [0, length], per unit of length.
PURE real pdf_rod_table(real3 q, real3 a, real3 b, real length, real eye_length, GuideMedia media, TableShape shape, real v)
{
    RodFrame f = rod_frame(q, a, b, length);
    RodTable t = rod_table(f, rod_whole(f), rod_view(f, q, a, b, eye_length, media), shape);
    return pdf_rod(q, a, b, length, v) * place_in_rod_table(t, shape, invert_rod(q, a, b, length, v)).density;
}

/// The xi for which sample_rod_table returns v.
PURE real invert_rod_table(real3 q, real3 a, real3 b, real length, real eye_length, GuideMedia media, TableShape shape, real v)
{
    RodFrame f = rod_frame(q, a, b, length);
    RodTable t = rod_table(f, rod_whole(f), rod_view(f, q, a, b, eye_length, media), shape);
    return place_in_rod_table(t, shape, invert_rod(q, a, b, length, v)).below;
}

#endif
