/// Where on a virtual ray light to connect a surface point: density proportional to max(n . omega, 0) / w^2, in closed form, without an angle
/// (kernels/README.md, eqs. 21-25). Directions are unit vectors.
#ifndef SURFACE_ROD_H
#define SURFACE_ROD_H

#include "kernels/dialect.h"

typedef struct {
    real v;       ///< distance along the light, in [0, length]
    real weight;  ///< max(n . omega, 0) / (w^2 pdf(v)): the integral of max(n . omega, 0) / w^2 over the light, per unit of length; 0 if it is below the horizon
} SurfaceRodSample;

/// The part of the light above the horizon, in units of `scale`, with what its ends look like from the surface point.
typedef struct {
    real scale;
    real start, length;   ///< of the part; length 0: nothing is above the horizon
    real r0, r1;          ///< distances of its ends
    real c0, c1;          ///< cosines at its ends, >= 0
    real t0;              ///< position of its start along the light, from the foot of the surface point
    real D2;              ///< square of the distance to the light's line
    real k;               ///< tan(Theta / 2) / D
} SurfaceRodFrame;

/// tan(Theta / 2) / D of two points with distances r0, r1 and positions t0, t0 + length on a line at the distance sqrt(D2) (eq. 22).
PURE real half_angle_over(real r0, real r1, real t0, real length, real D2)
{
    real cosine = fma(t0, t0 + length, D2), product = r0 * r1;             // cosine r0 r1
    real obtuse = (product - cosine) / fmax(D2 * length, REAL_SMALLEST);
    return select(length / fmax(product + cosine, REAL_SMALLEST), obtuse, cosine < R(0.0));
}

PURE SurfaceRodFrame surface_rod_frame(real3 p, real3 b, real length, real3 n)
{
    SurfaceRodFrame f;
    real size = fmax(fmax(largest3(p), REAL_EPSILON * length), R(0x1p-100));
    f.scale = power_of_two_below(size);
    real inverse = reciprocal_power_of_two(size);
    real3 q = make_real3(p.x * inverse, p.y * inverse, p.z * inverse), moment = cross3(q, b);
    real whole_length = length * inverse;
    real height = dot3(n, q), slope = dot3(n, b);                         // n . y(v) = height + v slope
    real horizon = -height / select(slope, R(1.0), slope == R(0.0));
    mask rises = slope > R(0.0), falls = slope < R(0.0);
    f.start = select(R(0.0), fmin(fmax(horizon, R(0.0)), whole_length), rises);
    real end = select(whole_length, fmin(fmax(horizon, R(0.0)), whole_length), falls);
    end = select(end, f.start, !rises & !falls & (height <= R(0.0)));
    f.length = fmax(end - f.start, R(0.0));
    f.D2 = fmax(dot3(moment, moment), REAL_EPSILON * REAL_EPSILON * REAL_EPSILON);
    f.t0 = dot3(q, b) + f.start;
    real t1 = f.t0 + f.length;
    f.r0 = sqrt(fma(f.t0, f.t0, f.D2));
    f.r1 = sqrt(fma(t1, t1, f.D2));
    f.c0 = fmax(fma(f.start, slope, height), R(0.0)) / f.r0;
    f.c1 = fmax(fma(end, slope, height), R(0.0)) / f.r1;
    f.k = half_angle_over(f.r0, f.r1, f.t0, f.length, f.D2);
    return f;
}

/// Integral of cos / w^2 over the part, in 1 / scale (eq. 21). Over an arc of directions it is at most 2 / D; the product exceeds that only where rounding decides on which side
/// of the surface point the light runs, and its cosines are no longer any (eq. 21a).
PURE real surface_rod_integral(SurfaceRodFrame f) { return fmin(f.k * (f.c0 + f.c1), R(2.0) / sqrt(f.D2)); }

/// Offset from an end (distance r, position t along the light from the foot, inwards positive, cosine c) after the share `x` of the integral, eqs. 23-25.
typedef struct { real offset, accuracy; } SurfaceRodOffset;
PURE SurfaceRodOffset surface_rod_offset(real D2, real k, real r, real t, real share)
{
    real j = k * share;
    mask before = t > R(0.0);
    real up = select(D2 / fmax(r - t, REAL_SMALLEST), r + t, before);     // r + t
    real down = select(r - t, D2 / fmax(r + t, REAL_SMALLEST), before);   // r - t
    real gap = fma(-up, j, R(1.0));
    SurfaceRodOffset o;
    o.offset = R(2.0) * j * r * r / fmax(gap * fma(down, j, R(1.0)), REAL_SMALLEST);
    o.accuracy = gap;
    return o;
}

/// p: the light's origin seen from the surface point; b: light's direction; n: unit normal; xi in [0, 1).
PURE SurfaceRodSample sample_surface_rod(real3 p, real3 b, real length, real3 n, real xi)
{
    SurfaceRodFrame f = surface_rod_frame(p, b, length, n);
    real rest = R(1.0) - xi, sum = f.c0 + f.c1, T2 = f.k * f.k * f.D2;
    real root = sqrt(fma(xi * rest * T2, sum * sum, fma(xi, f.c1 * f.c1, rest * (f.c0 * f.c0))));       // eq. 23
    SurfaceRodOffset first = surface_rod_offset(f.D2, f.k, f.r0, f.t0, xi * sum / fmax(f.c0 + root, REAL_SMALLEST));
    SurfaceRodOffset last = surface_rod_offset(f.D2, f.k, f.r1, -(f.t0 + f.length), rest * sum / fmax(f.c1 + root, REAL_SMALLEST));
    // eq. 25: take the end whose offset has the smaller error.
    mask from_end = last.offset * fabs(first.accuracy) < first.offset * fabs(last.accuracy);
    real from_start = select(first.offset, f.length - last.offset, from_end);
    from_start = fmin(fmax(from_start, R(0.0)), f.length);
    SurfaceRodSample s;
    s.v = fmin((f.start + from_start) * f.scale, length);
    s.weight = surface_rod_integral(f) / f.scale;
    return s;
}

/// What sample_surface_rod returns when it draws v in [0, length].
PURE SurfaceRodSample surface_rod_at(real3 p, real3 b, real length, real3 n, real v)
{
    SurfaceRodFrame f = surface_rod_frame(p, b, length, n);
    SurfaceRodSample s;
    s.v = v;
    s.weight = surface_rod_integral(f) / f.scale;
    return s;
}

/// Density of sample_surface_rod at v, per unit of length; 0 below the horizon.
PURE real pdf_surface_rod(real3 p, real3 b, real length, real3 n, real v)
{
    SurfaceRodFrame f = surface_rod_frame(p, b, length, n);
    real t = f.t0 + (v / f.scale - f.start), w2 = fma(t, t, f.D2);
    real cosine = fmax(fma(v, dot3(n, b), dot3(n, p)) / f.scale, R(0.0)) / sqrt(w2), total = surface_rod_integral(f);
    return select(R(0.0), cosine / (w2 * total * f.scale), total > R(0.0));
}

/// The xi for which sample_surface_rod returns v; 0 and 1 beyond the horizon.
PURE real invert_surface_rod(real3 p, real3 b, real length, real3 n, real v)
{
    SurfaceRodFrame f = surface_rod_frame(p, b, length, n);
    real part = fmin(fmax(v / f.scale - f.start, R(0.0)), f.length), t = f.t0 + part, r = sqrt(fma(t, t, f.D2));
    real cosine = fmax(fma(v, dot3(n, b), dot3(n, p)) / f.scale, R(0.0)) / r;
    real below = half_angle_over(f.r0, r, f.t0, part, f.D2) * (f.c0 + cosine), total = surface_rod_integral(f);
    return fmin(select(R(0.0), below / total, total > R(0.0)), R(1.0));
}

#endif
