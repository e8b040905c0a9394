/// Density estimation: what light paths carry is spread over a radius, and eyes take what reaches them (kernels/README.md, section 19).
#ifndef BLUR_H
#define BLUR_H

#include "kernels/math/transmittance.h"

/// Kernels of Epanechnikov: x2 is the square of the distance. Their integrals over the line and over the plane are 1; 0 from the radius on (eq. 65).
PURE real blur_over_line(real x2, real radius) { return R(0.75) / radius * fmax(R(1.0) - x2 / (radius * radius), R(0.0)); }
PURE real blur_over_plane(real x2, real radius)
{
    real square = radius * radius;
    return R(0.63661977236758134308) / square * fmax(R(1.0) - x2 / square, R(0.0));        // 2 / pi
}

/// Where an eye takes light from a record: distances along the light and the eye segment, and what the kernel gives, 0 if they do not meet. Per length along an eye segment, times that length:
/// 1 / length; at a point: 1 / length^2.
typedef struct { real v, u, weight; } Meeting;

/// Above this sine of their angle two lines meet at one place, whatever their lengths: 1 / sine is at most its inverse.
#define WIDE_ANGLE R(0.5)

/// A beam's line y(v) = q + v b, 0 <= v <= beam_length, seen from the eye segment u a, 0 <= u <= eye_length, and spread over `radius`. Across: at the nearest points of both, over the common
/// perpendicular, 1 / sine (eq. 66) [Jarosz et al. 2011]. Along, where the pair's own parallelogram is thinner than the radius: over the beam's cross section, at a place drawn by
/// xi in [0, 1) where they run side by side, in proportion to exp(-fading times the distance) (eq. 67). Which of the two depends on angle and lengths alone, so each spreads all of the beam. a, b: unit.
PURE Meeting meet_beam(real3 q, real3 a, real eye_length, real3 b, real beam_length, real radius, real fading, real xi)
{
    real3 n = cross3(a, b), offset = cross3(q, b);
    real sine2 = dot3(n, n);
    mask across = sqrt(sine2) * fmax(fmin(eye_length, beam_length), radius / WIDE_ANGLE) >= radius;
    real over = R(1.0) / select(R(1.0), sine2, across), gap = dot3(q, n);
    real u = dot3(offset, n) * over, v = dot3(cross3(q, a), n) * over;
    mask inside = (u >= R(0.0)) & (u <= eye_length) & (v >= R(0.0)) & (v <= beam_length);
    real weight = select(R(0.0), blur_over_line(gap * gap * over, radius) * sqrt(over), inside);

    real cosine = dot3(a, b), before = dot3(q, b), over_cosine = R(1.0) / select(cosine, R(1.0), across);       // |cosine| > .8 where it counts
    real from = before * over_cosine, to = (before + beam_length) * over_cosine;
    real first = fmin(fmax(fmin(from, to), R(0.0)), eye_length), last = fmin(fmax(fmax(from, to), R(0.0)), eye_length);
    real drawn = sample_distance(fading, last - first, xi), beside = first + drawn;
    real3 apart = along3(offset, -beside, n);

    Meeting m;
    m.u = select(beside, fmin(fmax(u, R(0.0)), eye_length), across);
    m.v = fmin(fmax(select(fma(beside, cosine, -before), v, across), R(0.0)), beam_length);
    m.weight = select(blur_over_plane(dot3(apart, apart), radius) / pdf_distance(fading, last - first, drawn), weight, across);
    return m;
}

#endif
