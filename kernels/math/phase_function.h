/// Phase functions of (direction of travel before, direction of travel after), per steradian.
#ifndef PHASE_FUNCTION_H
#define PHASE_FUNCTION_H

#include "kernels/dialect.h"

#define INVERSE_FOUR_PI R(0.079577471545947667884)

/// |g| is cut at 1 - 2^-20: there the lobe is 1e-6 rad wide, narrower than float directions can tell apart (hard_cases row 15).
#define LARGEST_ASYMMETRY R(0.99999904632568359375)

PURE real phase_isotropic(void) { return INVERSE_FOUR_PI; }

PURE real clamped_asymmetry(real g) { return fmin(fmax(g, -LARGEST_ASYMMETRY), LARGEST_ASYMMETRY); }

/// Henyey and Greenstein 1941, without the cancellation of 1 + g^2 - 2 g cos (eq. 16): in, out unit vectors, g the mean cosine.
PURE real phase_henyey_greenstein(real3 in, real3 out, real g)
{
    g = clamped_asymmetry(g);
    real size = fabs(g), gap = R(1.0) - size;
    real side = select(R(1.0), R(-1.0), g < R(0.0));
    real3 d = along3(in, -side, out);
    real r2 = fma(size, dot3(d, d), gap * gap);
    return INVERSE_FOUR_PI * gap * (R(1.0) + size) / (r2 * sqrt(r2));
}

/// 1 - cos and 1 + cos of a scattering angle: near the peak of a lobe the cosine itself has no digits left.
typedef struct { real one_minus, one_plus; } ScatterCosine;

/// Exact inverse of the cumulative distribution, for every g including 0 (eq. 17). The relative error of both members is a few epsilon. xi in [0, 1].
PURE ScatterCosine sample_henyey_greenstein_cosine(real g, real xi)
{
    g = clamped_asymmetry(g);
    real rest = R(1.0) - xi, less = R(1.0) - g, more = R(1.0) + g;
    real k = R(1.0) / fma(less, rest, more * xi);
    real l = less * k, m = more * k;
    ScatterCosine c;
    c.one_minus = R(2.0) * rest * fma(g, xi, R(1.0)) * l * l;
    c.one_plus = R(2.0) * xi * fma(-g, rest, R(1.0)) * m * m;
    return c;
}

/// The cosine alone, in [-1, 1], growing with xi.
PURE real sample_henyey_greenstein(real g, real xi)
{
    ScatterCosine c = sample_henyey_greenstein_cosine(g, xi);
    real cosine = select(c.one_plus - R(1.0), R(1.0) - c.one_minus, c.one_minus < R(1.0));
    return fmin(fmax(cosine, R(-1.0)), R(1.0));
}

/// Density per unit of cosine (2 pi times the phase function).
PURE real pdf_henyey_greenstein(real g, ScatterCosine c)
{
    g = clamped_asymmetry(g);
    real size = fabs(g), gap = R(1.0) - size;
    real r2 = fma(R(2.0) * size, select(c.one_minus, c.one_plus, g < R(0.0)), gap * gap);
    return R(0.5) * gap * (R(1.0) + size) / (r2 * sqrt(r2));
}

/// The xi for which sample_henyey_greenstein_cosine returns c (eq. 18).
PURE real invert_henyey_greenstein(real g, ScatterCosine c)
{
    g = clamped_asymmetry(g);
    real size = fabs(g), gap = R(1.0) - size;
    real r = sqrt(fma(R(2.0) * size, select(c.one_minus, c.one_plus, g < R(0.0)), gap * gap));
    return (R(1.0) - g) * c.one_plus / (r * ((R(1.0) + g) + r));
}

#endif
