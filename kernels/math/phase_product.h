/// The talk's conditional for anisotropic media [Novak et al. 2012]: where on the eye segment to connect, seen from a point of the light, in proportion to the
/// product of the phase functions at both ends and, if asked, of the transmittance; piecewise linear in the angle. Written as a warp of the fraction x of the
/// subtended angle, so that sample_equiangular(x) keeps its accuracy and the pair's weight stays in its cancelled form: weight / density (kernels/README.md,
/// eqs. 28-31, 43).
#ifndef PHASE_PRODUCT_H
#define PHASE_PRODUCT_H

#include "kernels/math/equiangular.h"
#include "kernels/math/linear_piece.h"

#define PHASE_VERTICES 10
/// Share of the samples that is spread evenly over the angle: a lobe narrower than the spacing of the vertices is missed by the table but not by these.
#define DEFENSIVE_SHARE R(0.1)
/// Beyond so many mean free paths a density stays even: e^-40 of the light is left, and its values stay normal numbers.
#define DEEPEST_GUIDE R(40.0)

typedef struct {
    real x;        ///< fraction of the angle Theta, in [0, 1]
    real density;  ///< of x, relative to uniform; at least DEFENSIVE_SHARE
} PhaseWarp;

/// What a density follows. It need not be what is there: sampling and dividing use the same.
typedef struct {
    real g_eye, g_light;                        ///< mean cosines in (-1, 1)
    real sigma_eye, sigma_light, sigma_leg;     ///< extinction along eye segment, light and connection, per unit of length
} GuideMedia;

/// Numbers that are known when the kernel is built: loops unroll, and what is 0 costs nothing.
typedef struct {
    int vertices;  ///< 2 ... PHASE_VERTICES
    int lobes;     ///< follow the phase functions
    int absorbs;   ///< follow the transmittance
} WarpShape;

/// What the light sees of the eye segment. Angles psi are measured at the point from -a, so that they lie in [0, pi] and grow along the segment.
typedef struct {
    real start, extent;       ///< psi of the segment's origin, and Theta
    real across, along;       ///< light's direction in the plane of point and segment: its products with the unit vector to the foot, and with a
    real g_eye, g_light;
    real peak, split;         ///< fraction of Theta nearest to the light's lobe, and the number of the vertex that is put there
    real D, foot, length;     ///< distance to the segment's line, position of the foot, length of the segment, in units of the point's scale
    real furthest;            ///< an upper bound of the connection's length there
    real depth_eye, depth_leg;  ///< extinctions in those units
} PhaseFan;

/// p: the point seen from the segment's origin; a, b: directions of segment and light.
PURE PhaseFan phase_fan(real3 p, real3 a, real length, real3 b, GuideMedia media, WarpShape shape)
{
    AngleFrame f = angle_frame(p, a, length);
    PhaseFan fan;
    fan.start = upper_atan2(f.D, -f.t0);
    fan.extent = f.angle;
    fan.along = dot3(a, b);
    fan.across = -fma(-dot3(p, a), fan.along, dot3(p, b)) / (f.D * f.scale);
    fan.across = fmin(fmax(fan.across, R(-1.0)), R(1.0));          // |across| <= 1; rounding exceeds it where D is nearly 0
    fan.g_eye = media.g_eye, fan.g_light = media.g_light;
    real last = (real)(float)(shape.vertices - 1);
    fan.peak = R(1.0), fan.split = last;
    if (shape.lobes) {
        real towards = select(R(-1.0), R(1.0), fan.g_light >= R(0.0));  // a backward lobe peaks where a forward one is weakest
        real psi = upper_atan2(fmax(towards * fan.across, R(0.0)), -towards * fan.along);
        fan.peak = fmin(fmax((psi - fan.start) / fmax(fan.extent, REAL_SMALLEST), R(0.0)), R(1.0));
        fan.peak = select(fan.peak, R(1.0), fan.g_light == R(0.0));     // no lobe: laid as if none had been asked for
        // Vertices on both sides in proportion to the angle there; none on a side that is empty.
        fan.split = select(fmin(fmax(rint(last * fan.peak), R(1.0)), last - R(1.0)), R(0.0), fan.peak <= R(0.0));
        fan.split = select(fan.split, last, fan.peak >= R(1.0));
    }
    fan.D = f.D, fan.foot = -f.t0, fan.length = f.length;
    fan.furthest = f.D + fmax(fabs(f.t0), fabs(f.t1));
    fan.depth_eye = media.sigma_eye * f.scale, fan.depth_leg = media.sigma_leg * f.scale;
    return fan;
}

/// Fraction of the angle at vertex j = 0 ... vertices - 1: from the ends to the peak, close together at both (smoothstep in place of a cosine).
PURE real fan_vertex(PhaseFan fan, WarpShape shape, real j)
{
    mask before = j <= fan.split;
    real from = select(fan.peak, R(0.0), before), to = select(R(1.0), fan.peak, before), last = (real)(float)(shape.vertices - 1);
    real steps = select(last - fan.split, fan.split, before), t = select(j - fan.split, j, before) / fmax(steps, R(1.0));
    return fma(to - from, t * t * fma(R(-2.0), t, R(3.0)), from);
}

/// A direction of the fan.
typedef struct { real sine, cosine; } FanDirection;
PURE FanDirection fan_direction(PhaseFan fan, real x)
{
    real psi = fma(x, fan.extent, fan.start);
    SineCosine s = sine_cosine(psi);
    FanDirection d = {s.sine_over * psi, s.cosine};
    return d;
}

/// Cosines of the scattering angles at both ends (eq. 28).
typedef struct { real eye, light; } FanCosines;
PURE FanCosines fan_cosines(PhaseFan fan, FanDirection d)
{
    FanCosines mu = {d.cosine, fma(fan.across, d.sine, -fan.along * d.cosine)};
    return mu;
}

/// (e l) of eq. 29: the product of the phase functions, up to a constant factor, is its power -3/2, positive and below (1 - |g|)^-6 of the larger |g|.
PURE real phase_denominator(PhaseFan fan, FanDirection d)
{
    FanCosines mu = fan_cosines(fan, d);
    real ge = fabs(fan.g_eye), gl = fabs(fan.g_light);
    real eye = fma(R(2.0) * ge, fmax(R(1.0) - select(-mu.eye, mu.eye, fan.g_eye >= R(0.0)), R(0.0)), (R(1.0) - ge) * (R(1.0) - ge));
    real light = fma(R(2.0) * gl, fmax(R(1.0) - select(-mu.light, mu.light, fan.g_light >= R(0.0)), R(0.0)), (R(1.0) - gl) * (R(1.0) - gl));
    return eye * light;
}

/// Transmittance along the eye segment and the connection: w = D / sin psi, u = foot - D cot psi (eq. 43).
PURE real fan_transmittance(PhaseFan fan, real over_sine, real cosine)
{
    real w = fmin(fan.D * over_sine, fan.furthest), u = fmin(fmax(fma(-fan.D * cosine, over_sine, fan.foot), R(0.0)), fan.length);
    return decay(fmin(fma(fan.depth_eye, u, fan.depth_leg * w), DEEPEST_GUIDE));
}

/// What the density follows in that direction; positive.
PURE real fan_value(PhaseFan fan, WarpShape shape, FanDirection d)
{
    if (!shape.absorbs) {
        real both = phase_denominator(fan, d);
        return R(1.0) / (both * sqrt(both));
    }
    real floored = fmax(d.sine, REAL_EPSILON);                               // sin(pi) is a rounding error, of either sign
    if (!shape.lobes) return fan_transmittance(fan, R(1.0) / floored, d.cosine);
    real both = phase_denominator(fan, d), once = R(1.0) / (both * floored), over = once * both, power = once * floored;
    return power * sqrt(power) * fan_transmittance(fan, over, d.cosine);     // 1 / sine and 1 / (e l) from one division
}

/// The table: fractions and values at the vertices, the defensive share in them, and the integral of the line through them.
typedef struct {
    real x[PHASE_VERTICES], value[PHASE_VERTICES];
    real total;
} PhaseTable;

/// The table with the defensive share: a constant under the line, so that there is no choice between two densities. Values that are 0 at every vertex make it even.
PURE PhaseTable with_even_share(PhaseTable t, WarpShape shape)
{
    t.total = R(0.0);
    for (int j = 1; j < shape.vertices; ++j) t.total = fma(R(0.5) * (t.x[j] - t.x[j - 1]), t.value[j - 1] + t.value[j], t.total);
    mask lit = t.total > R(0.0);
    t.total = select(R(1.0), t.total, lit);
    real even = t.total * (DEFENSIVE_SHARE / (R(1.0) - DEFENSIVE_SHARE));
    for (int j = 0; j < shape.vertices; ++j) t.value[j] = select(R(1.0), t.value[j], lit) + even;
    t.total = t.total + even;
    return t;
}

PURE PhaseTable phase_table(PhaseFan fan, WarpShape shape)
{
    FanDirection direction[PHASE_VERTICES];
    PhaseTable t;
    for (int j = 0; j < shape.vertices; ++j) {
        t.x[j] = fan_vertex(fan, shape, (real)(float)j);
        direction[j] = fan_direction(fan, t.x[j]);
    }
    for (int j = 0; j < shape.vertices; ++j) t.value[j] = fan_value(fan, shape, direction[j]);
    return with_even_share(t, shape);
}

/// Relative density at fraction x: the table's line there over its mean.
PURE real table_density(PhaseTable t, WarpShape shape, real x)
{
    real f0 = t.value[0], f1 = t.value[1], from = t.x[0], to = t.x[1];
    for (int j = 1; j + 1 < shape.vertices; ++j) {
        mask beyond = x >= t.x[j];
        f0 = select(f0, t.value[j], beyond), f1 = select(f1, t.value[j + 1], beyond);
        from = select(from, t.x[j], beyond), to = select(to, t.x[j + 1], beyond);
    }
    real r = fmin(fmax((x - from) / fmax(to - from, REAL_SMALLEST), R(0.0)), R(1.0));
    return fma(r, f1 - f0, f0) / t.total;
}

/// A draw from the table.
PURE PhaseWarp warp_phase_table(PhaseTable t, WarpShape shape, real xi)
{
    real target = xi * t.total, f0 = t.value[0], f1 = t.value[1], from = t.x[0], to = t.x[1], below = R(0.0), sum = R(0.0);
    for (int j = 0; j + 1 < shape.vertices; ++j) {
        mask beyond = (target >= sum) & (t.x[j + 1] > t.x[j]);      // the last piece that begins before the target and is not empty
        f0 = select(f0, t.value[j], beyond), f1 = select(f1, t.value[j + 1], beyond);
        from = select(from, t.x[j], beyond), to = select(to, t.x[j + 1], beyond), below = select(below, sum, beyond);
        sum = fma(R(0.5) * (t.x[j + 1] - t.x[j]), t.value[j] + t.value[j + 1], sum);
    }
    real area = R(0.5) * (to - from) * (f0 + f1);
    real within = fmin(fmax((target - below) / fmax(area, REAL_SMALLEST), R(0.0)), R(1.0)), r = sample_linear(f0, f1, within);
    PhaseWarp w;
    w.x = fmin(fmax(fma(to - from, r, from), R(0.0)), R(1.0));
    real rounded = fmin(fmax((w.x - from) / fmax(to - from, REAL_SMALLEST), R(0.0)), R(1.0));  // of a narrow piece, x is not quite where r is
    w.density = fma(rounded, f1 - f0, f0) / t.total;
    return w;
}

/// xi in [0, 1); x grows with it.
PURE PhaseWarp sample_phase_product(real3 p, real3 a, real length, real3 b, GuideMedia media, WarpShape shape, real xi)
{
    return warp_phase_table(phase_table(phase_fan(p, a, length, b, media, shape), shape), shape, xi);
}

/// Density of sample_phase_product's x, relative to uniform.
PURE real pdf_phase_product(real3 p, real3 a, real length, real3 b, GuideMedia media, WarpShape shape, real x)
{
    return table_density(phase_table(phase_fan(p, a, length, b, media, shape), shape), shape, x);
}

#endif
