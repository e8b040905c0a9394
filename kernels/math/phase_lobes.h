/// Phase functions that are sums of lobes (Henyey and Greenstein's, Rayleigh's, tables), for a medium and for a group of eyes, and the product conditional of
/// section 9 for them (kernels/README.md, eq. 32). Only kernels of the feature PHASE_LOBES hold any of this; a medium without lobes takes the same
/// way through Henyey and Greenstein's function with and without it.
#ifndef PHASE_LOBES_H
#define PHASE_LOBES_H

#include "kernels/math/phase_function.h"
#include "kernels/math/phase_product.h"
#include "kernels/shared/medium.h"
#include "kernels/shared/phase_lobe.h"
#include "kernels/shared/scene_features.h"

/// What the lobes of all media refer to.
typedef struct {
    __global const PhaseLobeRecord* lobes;
    __global const float* values;
} PhaseTables;

/// The phase function of one medium: Henyey and Greenstein's for g if it has no lobes.
typedef struct {
    uint first_lobe, lobe_count;
    float g;
} PhaseRange;

/// Those of a group of eyes: the distinct ones, with the number of the medium of each, and the medium of each lane.
typedef struct {
    uint count, has_lobes;  ///< has_lobes: 1 if one of them has any
    bits which;
    PhaseRange ranges[LANES];
    uint medium[LANES];
} PhaseLanes;

PURE PhaseRange phase_range(MediumRecord medium)
{
    PhaseRange range = {medium.first_lobe, medium.lobe_count, medium.g};
    return range;
}

/// (3 / 16 pi) (1 + mu^2)
PURE real phase_rayleigh(real mu) { return R(0.059683103659460750913) * fma(mu, mu, R(1.0)); }

/// Linear between count >= 2 values at equally spaced mu from -1 to 1. mu is clamped: rounding exceeds the ends, and no index may leave the table, also not
/// for a mu that is not a number.
PURE real phase_table_value(__global const float* values, uint first, uint count, real mu)
{
    real last = (real)(float)(count - 1u);
    real position = fmin(fmax(R(0.5) * (mu + R(1.0)), R(0.0)), R(1.0)) * last;
    real step = fmin(floor(position), last - R(1.0)), offset = position - step;
    bits at = to_bits(step) + first;
    return fma(offset, gather_lanes(values, at + 1u), (R(1.0) - offset) * gather_lanes(values, at));
}

/// Per steradian.
PURE real phase_of_lobe(PhaseLobeRecord lobe, __global const float* values, real3 in, real3 out)
{
    if (lobe.kind == PHASE_LOBE_RAYLEIGH) return phase_rayleigh(dot3(in, out));
    if (lobe.kind == PHASE_LOBE_TABLE) return phase_table_value(values, lobe.first_value, lobe.value_count, dot3(in, out));
    return phase_henyey_greenstein(in, out, (real)lobe.g);
}

/// Phase function of one medium, per steradian; in, out: unit directions of travel (eq. 32).
PURE real phase_of(PhaseRange range, PhaseTables tables, real3 in, real3 out)
{
    if (!PHASE_LOBES || range.lobe_count == 0u) return phase_henyey_greenstein(in, out, (real)range.g);
    real sum = R(0.0);
    for (uint i = 0; i < range.lobe_count; ++i) {
        PhaseLobeRecord lobe = tables.lobes[range.first_lobe + i];
        sum = fma((real)lobe.weight, phase_of_lobe(lobe, tables.values, in, out), sum);
    }
    return sum;
}

/// Phase function of every lane's medium; g: their mean cosines.
PURE real phase_of_lanes(PhaseLanes lanes, PhaseTables tables, real g, real3 in, real3 out)
{
    if (!PHASE_LOBES || lanes.has_lobes == 0u) return phase_henyey_greenstein(in, out, g);
    real phase = phase_of(lanes.ranges[0], tables, in, out);
    for (uint i = 1; i < lanes.count; ++i) phase = select(phase, phase_of(lanes.ranges[i], tables, in, out), to_mask(lanes.which == lanes.medium[i]));
    return phase;
}

/// Henyey and Greenstein's function of mu alone.
PURE real phase_henyey_greenstein_at(real g, real mu)
{
    ScatterCosine c = {fmax(R(1.0) - mu, R(0.0)), fmax(R(1.0) + mu, R(0.0))};
    return R(2.0) * INVERSE_FOUR_PI * pdf_henyey_greenstein(g, c);
}

/// phase_of as a function of mu alone, for the vertices of the product conditional: less exact at a peak.
PURE real phase_at_cosine(PhaseRange range, PhaseTables tables, real mu)
{
    if (range.lobe_count == 0u) return phase_henyey_greenstein_at((real)range.g, mu);
    real sum = R(0.0);
    for (uint i = 0; i < range.lobe_count; ++i) {
        PhaseLobeRecord lobe = tables.lobes[range.first_lobe + i];
        real value;
        if (lobe.kind == PHASE_LOBE_RAYLEIGH) value = phase_rayleigh(mu);
        else if (lobe.kind == PHASE_LOBE_TABLE) value = phase_table_value(tables.values, lobe.first_value, lobe.value_count, mu);
        else value = phase_henyey_greenstein_at((real)lobe.g, mu);
        sum = fma((real)lobe.weight, value, sum);
    }
    return sum;
}

/// Value in a direction of the fan: the product of both phase functions per steradian^2.
PURE real lobe_product(PhaseFan fan, PhaseLanes eye, PhaseRange light, PhaseTables tables, FanDirection d)
{
    FanCosines mu = fan_cosines(fan, d);
    real of_eye = phase_at_cosine(eye.ranges[0], tables, mu.eye);
    for (uint i = 1; i < eye.count; ++i) of_eye = select(of_eye, phase_at_cosine(eye.ranges[i], tables, mu.eye), to_mask(eye.which == eye.medium[i]));
    return of_eye * phase_at_cosine(light, tables, mu.light);
}

/// As phase_table, for phase functions of which one at least has lobes.
PURE PhaseTable lobe_table(PhaseFan fan, PhaseLanes eye, PhaseRange light, PhaseTables tables, WarpShape shape)
{
    PhaseTable t;
    for (int j = 0; j < shape.vertices; ++j) {
        t.x[j] = fan_vertex(fan, shape, (real)(float)j);
        FanDirection d = fan_direction(fan, t.x[j]);
        t.value[j] = lobe_product(fan, eye, light, tables, d);
        if (shape.absorbs) t.value[j] = t.value[j] * fan_transmittance(fan, R(1.0) / fmax(d.sine, REAL_EPSILON), d.cosine);
    }
    return with_even_share(t, shape);
}

/// The table of phase functions with lobes or without. Vertices lie where a lobe of the sign of each medium's mean cosine has its peak; the even share covers every other.
PURE PhaseTable product_table(PhaseFan fan, PhaseLanes eye, PhaseRange light, PhaseTables tables, WarpShape shape)
{
    if (!PHASE_LOBES || (eye.has_lobes == 0u && light.lobe_count == 0u)) return phase_table(fan, shape);
    return lobe_table(fan, eye, light, tables, shape);
}

/// As sample_phase_product.
PURE PhaseWarp sample_lobe_product(real3 p, real3 a, real length, real3 b, GuideMedia media, PhaseLanes eye, PhaseRange light, PhaseTables tables, WarpShape shape, real xi)
{
    return warp_phase_table(product_table(phase_fan(p, a, length, b, media, shape), eye, light, tables, shape), shape, xi);
}

/// Density of sample_lobe_product's x, relative to uniform.
PURE real pdf_lobe_product(real3 p, real3 a, real length, real3 b, GuideMedia media, PhaseLanes eye, PhaseRange light, PhaseTables tables, WarpShape shape, real x)
{
    return table_density(product_table(phase_fan(p, a, length, b, media, shape), eye, light, tables, shape), shape, x);
}

#endif
