/// The talk's conditional for anisotropic media [Novak et al. 2012]: where on the eye segment to connect, seen from a point of the light, in proportion to the
/// product of the phase functions at both ends, piecewise linear in the angle with ten vertices. Written as a warp of the fraction x of the subtended
/// angle, so that sample_equiangular(x) keeps its accuracy and the pair's weight stays in its cancelled form: weight / density (kernels/README.md, eqs. 28-31).
#ifndef PHASE_PRODUCT_H
#define PHASE_PRODUCT_H

#include "kernels/math/equiangular.h"
#include "kernels/math/linear_piece.h"

#define PHASE_VERTICES 10
/// Share of the samples that is spread evenly over the angle: a lobe narrower than the spacing of the vertices is missed by the table but not by these.
#define DEFENSIVE_SHARE R(0.1)

typedef struct {
    real x;        ///< fraction of the angle Theta, in [0, 1]
    real density;  ///< of x, relative to uniform; at least DEFENSIVE_SHARE
} PhaseWarp;

/// What a point of the light sees of the eye segment. Angles psi are measured at the point from -a, so that they lie in [0, pi] and grow along the segment.
typedef struct {
    real start, extent;       ///< psi of the segment's origin, and Theta
    real across, along;       ///< light's direction in the plane of point and segment: its products with the unit vector to the foot, and with a
    real g_eye, g_light;
    real peak, split;         ///< psi nearest to the light's lobe, and the number of the vertex that is put there
} PhaseFan;

/// p: the point seen from the segment's origin; a, b: directions of segment and light; g_eye, g_light: mean cosines in (-1, 1).
PURE PhaseFan phase_fan(real3 p, real3 a, real length, real3 b, real g_eye, real g_light)
{
    AngleFrame f = angle_frame(p, a, length);
    PhaseFan fan;
    fan.start = upper_atan2(f.D, -f.t0);
    fan.extent = f.angle;
    fan.along = dot3(a, b);
    fan.across = -fma(-dot3(p, a), fan.along, dot3(p, b)) / (f.D * f.scale);
    fan.across = fmin(fmax(fan.across, R(-1.0)), R(1.0));          // |across| <= 1; rounding exceeds it where D is nearly 0
    fan.g_eye = g_eye, fan.g_light = g_light;
    real towards = select(R(-1.0), R(1.0), g_light >= R(0.0));     // a backward lobe peaks where a forward one is weakest
    real low = fan.start, high = fan.start + fan.extent;
    fan.peak = fmin(fmax(upper_atan2(fmax(towards * fan.across, R(0.0)), -towards * fan.along), low), high);
    // Vertices on both sides in proportion to the angle there; none on a side that is empty.
    real vertices = R(9.0) * (fan.peak - low) / fmax(fan.extent, REAL_SMALLEST);
    fan.split = select(fmin(fmax(rint(vertices), R(1.0)), R(8.0)), R(0.0), fan.peak <= low);
    fan.split = select(fan.split, R(9.0), fan.peak >= high);
    return fan;
}

/// Angle of vertex j = 0 ... 9: from the ends to the peak, close together at both (smoothstep in place of a cosine).
PURE real fan_vertex(PhaseFan fan, real j)
{
    mask before = j <= fan.split;
    real from = select(fan.peak, fan.start, before), to = select(fan.start + fan.extent, fan.peak, before);
    real steps = select(R(9.0) - fan.split, fan.split, before), t = select(j - fan.split, j, before) / fmax(steps, R(1.0));
    return fma(to - from, t * t * fma(R(-2.0), t, R(3.0)), from);
}

/// Cosines of the scattering angles at both ends where the connection leaves under the angle psi (eq. 28).
typedef struct { real eye, light; } FanCosines;
PURE FanCosines fan_cosines(PhaseFan fan, real psi)
{
    SineCosine s = sine_cosine(psi);
    FanCosines mu = {s.cosine, fma(fan.across, s.sine_over * psi, -fan.along * s.cosine)};
    return mu;
}

/// Product of the phase functions where the connection leaves under the angle psi, up to a constant factor; positive, below (1 - |g|)^-6 of the larger |g|.
PURE real phase_product(PhaseFan fan, real psi)
{
    FanCosines mu = fan_cosines(fan, psi);
    real ge = fabs(fan.g_eye), gl = fabs(fan.g_light);
    real eye = fma(R(2.0) * ge, fmax(R(1.0) - select(-mu.eye, mu.eye, fan.g_eye >= R(0.0)), R(0.0)), (R(1.0) - ge) * (R(1.0) - ge));
    real light = fma(R(2.0) * gl, fmax(R(1.0) - select(-mu.light, mu.light, fan.g_light >= R(0.0)), R(0.0)), (R(1.0) - gl) * (R(1.0) - gl));
    real both = eye * light;
    return R(1.0) / (both * sqrt(both));
}

/// The table: angles and values at the vertices, and the integral of the line through them.
typedef struct {
    real angle[PHASE_VERTICES], value[PHASE_VERTICES];
    real total;
} PhaseTable;

PURE PhaseTable phase_table(PhaseFan fan)
{
    PhaseTable t;
    t.total = R(0.0);
    for (int j = 0; j < PHASE_VERTICES; ++j) {
        t.angle[j] = fan_vertex(fan, (real)(float)j);
        t.value[j] = phase_product(fan, t.angle[j]);
        if (j > 0) t.total = fma(R(0.5) * (t.angle[j] - t.angle[j - 1]), t.value[j - 1] + t.value[j], t.total);
    }
    return t;
}

/// Relative density at fraction x: the table's line there over its mean, with the defensive share.
PURE real table_density(PhaseTable t, PhaseFan fan, real x)
{
    real psi = fma(x, fan.extent, fan.start), f0 = t.value[0], f1 = t.value[1], from = t.angle[0], to = t.angle[1];
    for (int j = 1; j + 1 < PHASE_VERTICES; ++j) {
        mask beyond = psi >= t.angle[j];
        f0 = select(f0, t.value[j], beyond), f1 = select(f1, t.value[j + 1], beyond);
        from = select(from, t.angle[j], beyond), to = select(to, t.angle[j + 1], beyond);
    }
    real r = fmin(fmax((psi - from) / fmax(to - from, REAL_SMALLEST), R(0.0)), R(1.0));
    real relative = fma(r, f1 - f0, f0) * fan.extent / fmax(t.total, REAL_SMALLEST);
    relative = select(R(1.0), relative, t.total > R(0.0));         // an angle of 0 has no table, phase functions may be 0 at every vertex
    return fma(R(1.0) - DEFENSIVE_SHARE, relative, DEFENSIVE_SHARE);
}

/// Draws a fraction of the angle from the table. xi in [0, 1).
PURE PhaseWarp sample_phase_table(PhaseTable t, PhaseFan fan, real xi)
{
    mask even = xi < DEFENSIVE_SHARE;
    real rest = fmax((xi - DEFENSIVE_SHARE) / (R(1.0) - DEFENSIVE_SHARE), R(0.0)), target = rest * t.total;
    real f0 = t.value[0], f1 = t.value[1], from = t.angle[0], to = t.angle[1], below = R(0.0), sum = R(0.0);
    for (int j = 0; j + 1 < PHASE_VERTICES; ++j) {
        mask beyond = (target >= sum) & (t.angle[j + 1] > t.angle[j]);  // the last piece that begins before the target and is not empty
        f0 = select(f0, t.value[j], beyond), f1 = select(f1, t.value[j + 1], beyond);
        from = select(from, t.angle[j], beyond), to = select(to, t.angle[j + 1], beyond), below = select(below, sum, beyond);
        sum = fma(R(0.5) * (t.angle[j + 1] - t.angle[j]), t.value[j] + t.value[j + 1], sum);
    }
    real area = R(0.5) * (to - from) * (f0 + f1);
    real within = fmin(fmax((target - below) / fmax(area, REAL_SMALLEST), R(0.0)), R(1.0));
    real psi = fma(to - from, sample_linear(f0, f1, within), from);
    PhaseWarp w;
    real drawn = (psi - fan.start) / fmax(fan.extent, REAL_SMALLEST);
    w.x = select(select(xi, drawn, t.total > R(0.0)), xi / DEFENSIVE_SHARE, even & (t.total > R(0.0)));  // an empty table leaves the even density alone
    w.x = fmin(fmax(w.x, R(0.0)), R(1.0));
    w.density = table_density(t, fan, w.x);
    return w;
}

/// xi in [0, 1).
PURE PhaseWarp sample_phase_product(real3 p, real3 a, real length, real3 b, real g_eye, real g_light, real xi)
{
    PhaseFan fan = phase_fan(p, a, length, b, g_eye, g_light);
    return sample_phase_table(phase_table(fan), fan, xi);
}

/// Density of sample_phase_product's x, relative to uniform.
PURE real pdf_phase_product(real3 p, real3 a, real length, real3 b, real g_eye, real g_light, real x)
{
    PhaseFan fan = phase_fan(p, a, length, b, g_eye, g_light);
    return table_density(phase_table(fan), fan, x);
}

#endif
